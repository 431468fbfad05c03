package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Path;
import java.util.List;

/**
 * Files that are checked together, because a change of one may cause a finding in another. Equal
 * units check the same.
 */
interface CheckUnit {

  /** Returns the file that gets the findings about no file. */
  Path subject();

  /**
   * Reads the files, and texts instead of them, and checks them.
   *
   * @return what the command line finds, without what is suppressed
   * @throws dev.eventchain.diagnostics.DiagnosticException if there is nothing to check because a
   *     file cannot be read
   */
  List<Diagnostic> check();
}
