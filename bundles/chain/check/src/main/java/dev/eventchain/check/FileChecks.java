package dev.eventchain.check;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EPackage;

/** Checks of metamodels and rules for themselves, as editors make them: without any model. */
public final class FileChecks {

  private FileChecks() {}

  /**
   * Checks a metamodel, and the constraints in its annotations.
   *
   * @param all the metamodels edited together with it, which must not contradict each other
   * @throws DiagnosticException INPUT if it is no valid metamodel
   */
  public static Validation metamodel(Path file, List<Path> all) {
    List<EPackage> packages = new ArrayList<>();
    XmiStore store = Metamodels.loadLast(file, all, packages);
    OclRules rules = OclRules.parse(List.of(), packages, store::locateInMetamodel);
    return new Validation(covering(file), rules.diagnostics());
  }

  /**
   * Checks that a Complete OCL document can be parsed and analysed, with those that it imports.
   *
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static Validation rules(Path file, List<Path> metamodels) {
    List<SourceText> documents =
        OclRules.files(List.of(file)).stream().map(SourceText::read).toList();
    OclRules rules = OclRules.parse(documents, Metamodels.of(metamodels));
    List<Diagnostic> found = new ArrayList<>(rules.diagnostics());
    if (rules.constraints().isEmpty() && found.isEmpty()) {
      found.add(
          Diagnostic.of(
                  EditorRules.RULES_NONE,
                  "The document contains no invariant, so it checks nothing.",
                  SourceLocation.of(file))
              .withHint("Write one: context SoftwareNode inv HasName: name <> ''"));
    }
    return new Validation(covering(file), found);
  }

  /** Returns whether a document needs no other metamodel than that of event chains. */
  public static boolean isAboutChains(Path document) {
    return isSound(document, List.of(EventchainPackage.eINSTANCE));
  }

  /** Returns whether a document of rules can be analysed with metamodels. */
  public static boolean isSound(Path document, List<EPackage> packages) {
    try {
      List<SourceText> documents =
          OclRules.files(List.of(document)).stream().map(SourceText::read).toList();
      return !Diagnostic.anyError(OclRules.parse(documents, packages).diagnostics());
    } catch (DiagnosticException e) {
      return false; // its own check reports it
    }
  }

  /**
   * Checks a file and turns every failure into a finding, including defects of the program: what
   * was not checked must not look valid.
   *
   * @param subject the file that gets a finding if all others are about files that it needs
   */
  public static Validation attempt(Path subject, Supplier<Validation> check) {
    try {
      return check.get();
    } catch (DiagnosticException e) {
      return new Validation(Coverage.NONE, withSubject(subject, e.diagnostics()));
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      return new Validation(Coverage.NONE, List.of(failed(e)));
    }
  }

  /** Returns the finding about a failed check. */
  public static Diagnostic failed(Throwable failure) {
    return Diagnostic.of(
            EditorRules.CHECK_FAILED,
            "This was not checked, because the check itself failed: " + failure,
            DiagnosticException.placeOf(failure))
        .withHint("'eventchain validate' on the command line may say more; please report it.");
  }

  private static List<Diagnostic> withSubject(Path subject, List<Diagnostic> found) {
    SourceLocation place = SourceLocation.of(subject);
    if (found.stream().anyMatch(each -> each.location().file().equals(place.file()))) {
      return found;
    }
    List<Diagnostic> all = new ArrayList<>(found);
    Diagnostic first = found.get(0);
    all.add(
        Diagnostic.of(EditorRules.UNCHECKED, "This was not checked: " + first.message(), place)
            .withRelated(first.location()));
    return all;
  }

  private static Coverage covering(Path file) {
    return new Coverage(List.of(file.toString()), 0, List.of());
  }
}
