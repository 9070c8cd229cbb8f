//! GB_2D_CH; all of it is [`grafika::programs::gb_2d_ch`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_2d_ch::PROGRAM.main()
}
