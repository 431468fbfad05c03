package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.lsp.LanguageServerProgram;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code lsp}: the server that editors start. */
@Command(
    name = "lsp",
    mixinStandardHelpOptions = true,
    description = {
      "Serve an editor by the Language Server Protocol, over standard input and output.",
      "Editors start it; it ends with them. It finds what 'validate' and 'compile' find, as one types, in projects"
          + " (eventchain.yaml, requirements, scenarios, bench, software base), models, metamodels (*.ecore),"
          + " constraints (*.ocl) and templates (*.mtl). It writes nothing, asks no language model, and simulates"
          + " nothing."
    })
final class LspCommand implements Callable<Integer> {

  @SuppressWarnings("unused") // there is nothing to choose
  @Option(
      names = "--stdio",
      description = "Accepted, since many editors add it: there is no other way to connect.")
  private boolean stdio;

  private final Console console;

  LspCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    InputStream in = System.in;
    OutputStream out = new BufferedOutputStream(new FileOutputStream(FileDescriptor.out));
    System.setOut(System.err); // standard output belongs to the protocol
    return LanguageServerProgram.serve(in, out, console.err(), Main.version());
  }
}
