//! Sorting by small numbers, by counting.

/// The numbers of items, sorted by the buckets that the items belong to; those of a bucket in the order of the items.
pub(super) struct Buckets {
    /// Where every bucket begins, and where the last one ends.
    starts: Vec<u32>,
    sorted: Vec<u32>,
}

impl Buckets {
    /// Sorts items by their buckets, of which there are `count`. `None` if an item belongs to none of them, or there are
    /// more items than 32 bits count, which no grid has.
    pub(super) fn new(count: usize, items: impl Iterator<Item = usize> + Clone) -> Option<Buckets> {
        let mut starts = vec![0_u32; count.checked_add(1)?];
        for bucket in items.clone() {
            let start = starts.get_mut(bucket.checked_add(1)?)?;
            *start = start.checked_add(1)?;
        }
        let mut sum = 0_u32;
        for start in &mut starts {
            sum = sum.checked_add(*start)?;
            *start = sum;
        }
        // Every bucket's start moves to its end while the items are put, and back.
        let mut sorted = vec![0_u32; sum as usize];
        for (item, bucket) in (0_u32..).zip(items) {
            let start = starts.get_mut(bucket)?;
            *sorted.get_mut(*start as usize)? = item;
            *start += 1;
        }
        starts.pop();
        starts.insert(0, 0);
        Some(Buckets { starts, sorted })
    }

    /// The items of a bucket.
    pub(super) fn of(&self, bucket: usize) -> &[u32] {
        let bound = |index: usize| self.starts.get(index).map_or(0, |&start| start as usize);
        self.sorted.get(bound(bucket)..bound(bucket + 1)).unwrap_or_default()
    }

    /// The items of every bucket, to be put into another order.
    pub(super) fn each_mut(&mut self) -> impl Iterator<Item = &mut [u32]> {
        let mut rest = self.sorted.as_mut_slice();
        self.starts.windows(2).map(move |ends| {
            let (bucket, others) = std::mem::take(&mut rest).split_at_mut((ends[1] - ends[0]) as usize);
            rest = others;
            bucket
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_item_is_in_its_bucket_in_its_order(items in prop::collection::vec(0_usize..7, 0..40)) {
            let mut buckets = Buckets::new(7, items.iter().copied()).unwrap();
            for bucket in 0..7 {
                let right = (0_u32..).zip(&items).filter(|(_, it)| **it == bucket).map(|(item, _)| item);
                prop_assert_eq!(buckets.of(bucket), right.collect::<Vec<_>>());
            }
            prop_assert_eq!(buckets.each_mut().map(|bucket| bucket.len()).sum::<usize>(), items.len());
            prop_assert!(Buckets::new(7, [7].into_iter()).is_none());
        }
    }
}
