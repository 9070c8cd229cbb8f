//! GB_2D_IP; all of it is [`grafika::programs::gb_2d_ip`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_2d_ip::PROGRAM.main()
}
