package dev.eventchain.eclipse;

import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Validation;
import java.nio.file.Path;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * A unit of files that are checked together, because a change of one may cause a finding in
 * another: an Eventchain project, a model with its metamodels, a rules document, or a template.
 */
interface CheckUnit {

  /** Returns the file or folder of the unit, which gets the findings about no file. */
  IResource subject();

  /**
   * Returns whether the unit must be checked again after a file was changed or deleted.
   *
   * @param file a file of the same Eclipse project
   */
  boolean dependsOn(IFile file);

  /**
   * Reads the files as they are on disk and checks them.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if there is nothing to check because a
   *     file cannot be read
   */
  Validation check();

  /**
   * Checks a unit like {@link #check} and turns every failure into a finding, including defects of
   * the program: an unchecked unit must not look valid.
   */
  static Validation attempt(CheckUnit unit) {
    Path subject = CheckedFiles.pathOf(unit.subject()).orElse(Path.of(""));
    return FileChecks.attempt(subject, unit::check);
  }
}
