//! SOM_FEL; all of it is [`grafika::programs::som_fel`].

fn main() -> std::process::ExitCode {
    grafika::programs::som_fel::PROGRAM.main()
}
