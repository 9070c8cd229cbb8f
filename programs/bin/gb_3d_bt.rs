//! GB_3D_BT; all of it is [`grafika::programs::gb_3d_bt`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_3d_bt::PROGRAM.main()
}
