package dev.eventchain.eclipse;

import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;
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
   * @throws DiagnosticException if there is nothing to check because a file cannot be read
   */
  Validation check();

  /**
   * Checks a unit like {@link #check} and turns every failure into a finding, including defects of
   * the program: an unchecked unit must not look valid.
   */
  static Validation attempt(CheckUnit unit) {
    try {
      return unit.check();
    } catch (DiagnosticException e) {
      return new Validation(Coverage.NONE, withSubject(unit, e.diagnostics()));
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      return new Validation(Coverage.NONE, List.of(failed(e)));
    }
  }

  /** Returns the finding about a failed check. */
  static Diagnostic failed(Throwable failure) {
    return Diagnostic.of(
            EclipseRules.CHECK_FAILED,
            "This was not checked, because the check itself failed: " + failure,
            DiagnosticException.placeOf(failure))
        .withHint("'eventchain validate' on the command line may say more; please report it.");
  }

  /** Adds a finding about the unit's own file if all others concern files that it needs. */
  private static List<Diagnostic> withSubject(CheckUnit unit, List<Diagnostic> found) {
    String file = unit.subject().getLocation().toString();
    if (found.stream().anyMatch(each -> each.location().file().equals(file))) {
      return found;
    }
    List<Diagnostic> all = new ArrayList<>(found);
    Diagnostic first = found.get(0);
    all.add(
        Diagnostic.of(
                EclipseRules.UNCHECKED,
                "This was not checked: " + first.message(),
                SourceLocation.of(file))
            .withRelated(first.location()));
    return all;
  }
}
