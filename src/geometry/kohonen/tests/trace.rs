//! Learning step by step, against a prototype in doubles.

use super::super::{End, Learning, Net, Order, Rule, Topology, Weighting};
use crate::geometry::Point;
use crate::geometry::cloud::Cloud;
use serde::Deserialize;

/// A net before and after one pass through a cloud.
#[derive(Deserialize)]
struct Trace {
    weighting: String,
    topology: String,
    start: Vec<Vec<Point<3>>>,
    cloud: Vec<Point<3>>,
    net: Vec<Vec<Point<3>>>,
}

#[test]
fn one_pass_in_the_order_of_the_list_is_the_prototypes() {
    let traces: Vec<Trace> = serde_json::from_str(include_str!("trace.json")).unwrap();
    assert_eq!(traces.len(), 4);
    for trace in traces {
        let topology = Topology::of_name(&trace.topology).unwrap();
        let weighting = Weighting::of_name(&trace.weighting).unwrap();
        let cloud = Cloud::new(trace.cloud).unwrap();
        let start = Net::new(topology, &trace.start).unwrap();
        let rule = Rule { weighting, order: Order::Listed, ..Rule::default() };
        let mut learning = Learning::new(&cloud, start, rule).unwrap();
        assert_eq!(learning.advance(149), None);
        assert_eq!(learning.advance(1000), Some(End::Steps));
        assert_eq!((learning.t(), learning.wins().iter().sum::<u64>()), (150, 150));
        let pairs = learning.net().rows().concat().into_iter().zip(trace.net.concat());
        let error = pairs.flat_map(|(a, b)| [0, 1, 2].map(|d| (a[d] - b[d]).abs())).fold(0.0, f64::max);
        assert!(error < 1e-14, "{} {}: {error:e}", trace.weighting, trace.topology);
    }
}
