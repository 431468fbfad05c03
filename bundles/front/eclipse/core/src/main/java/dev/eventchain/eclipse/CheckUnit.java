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
 * What is checked together, because a finding about one of its files may come from a change of
 * another one: a project of Eventchain, a model with its metamodels, a document of rules, a
 * template.
 */
interface CheckUnit {

  /** The file or folder that the unit is about: findings that are about no file are set there. */
  IResource subject();

  /**
   * Whether the unit is to be checked again when a file has changed, which may be gone.
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
   * As {@link #check}, where everything that goes wrong is a finding: a defect of ours, too, since
   * a unit that was not checked must not look like a good one.
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

  /** The finding that a check broke, at what it was about when it did. */
  static Diagnostic failed(Throwable failure) {
    return Diagnostic.error(
            "eclipse.check.failed",
            "This was not checked, because the check itself failed: " + failure,
            DiagnosticException.placeOf(failure))
        .withHint("'eventchain validate' on the command line may say more; please report it.");
  }

  /** Adds a finding about the unit's own file, where all others are about files that it needs. */
  private static List<Diagnostic> withSubject(CheckUnit unit, List<Diagnostic> found) {
    String file = unit.subject().getLocation().toString();
    if (found.stream().anyMatch(each -> each.location().file().equals(file))) {
      return found;
    }
    List<Diagnostic> all = new ArrayList<>(found);
    Diagnostic first = found.get(0);
    all.add(
        Diagnostic.error(
                "eclipse.unchecked",
                "This was not checked: " + first.message(),
                SourceLocation.of(file))
            .withRelated(first.location()));
    return all;
  }
}
