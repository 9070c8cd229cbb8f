//! ZY_HSPL; all of it is [`grafika::programs::zy_hspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::zy_hspl::PROGRAM.main()
}
