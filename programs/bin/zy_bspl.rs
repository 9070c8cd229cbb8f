//! ZY_BSPL; all of it is [`grafika::programs::zy_bspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::zy_bspl::PROGRAM.main()
}
