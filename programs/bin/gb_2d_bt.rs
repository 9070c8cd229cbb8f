//! GB_2D_BT; all of it is [`grafika::programs::gb_2d_bt`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_2d_bt::PROGRAM.main()
}
