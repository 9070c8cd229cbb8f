//! CSAV_GY; all of it is [`grafika::programs::csav_gy`].

fn main() -> std::process::ExitCode {
    grafika::programs::csav_gy::PROGRAM.main()
}
