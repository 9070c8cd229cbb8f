//! GB_3D_IP; all of it is [`grafika::programs::gb_3d_ip`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_3d_ip::PROGRAM.main()
}
