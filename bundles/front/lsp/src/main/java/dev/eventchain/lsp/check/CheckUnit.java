package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Files that are checked together, because a change of one may cause a finding in another. Equal
 * units check the same.
 */
interface CheckUnit {

  /** Returns the file that gets the findings about no file. */
  Path subject();

  /** Returns the folder of the project that it checks, in which it may read any file. */
  default Optional<Path> project() {
    return Optional.empty();
  }

  /**
   * Reads the files, and texts instead of them, and checks them.
   *
   * @return what the command line finds, without what is suppressed
   * @throws dev.eventchain.diagnostics.DiagnosticException if there is nothing to check because a
   *     file cannot be read
   */
  List<Diagnostic> check();

  /** Unit about the files of a project, whose findings about no file its settings get. */
  interface OfProject extends CheckUnit {

    /** Returns the folder of the project. */
    Path folder();

    @Override
    default Path subject() {
      return new ProjectFolder(folder()).configurationFile();
    }

    @Override
    default Optional<Path> project() {
      return Optional.of(folder());
    }
  }
}
