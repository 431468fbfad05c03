package dev.eventchain.eclipse;

import dev.eventchain.check.Validation;
import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * A Complete OCL document; checks that it can be parsed and analysed with the project's metamodels.
 */
record RulesUnit(IFile file, Path path, List<Path> metamodels) implements CheckUnit {

  private static final Set<String> RELEVANT = Set.of("ocl", "ecore");

  /** Returns whether a document needs no other metamodel than that of event chains. */
  static boolean isAboutChains(Path document) {
    try {
      List<SourceText> documents =
          OclRules.files(List.of(document)).stream().map(SourceText::read).toList();
      return !Diagnostic.anyError(
          OclRules.parse(documents, List.of(EventchainPackage.eINSTANCE)).diagnostics());
    } catch (DiagnosticException e) {
      return false; // the metamodel's own unit reports it
    }
  }

  @Override
  public IResource subject() {
    return file;
  }

  /** Documents import others and use metamodels. */
  @Override
  public boolean dependsOn(IFile changed) {
    return RELEVANT.contains(String.valueOf(changed.getFileExtension()));
  }

  @Override
  public Validation check() {
    List<SourceText> documents =
        OclRules.files(List.of(path)).stream().map(SourceText::read).toList();
    OclRules rules = OclRules.parse(documents, Metamodels.of(metamodels));
    List<Diagnostic> found = new ArrayList<>(rules.diagnostics());
    if (rules.constraints().isEmpty() && found.isEmpty()) {
      found.add(
          Diagnostic.of(
                  EclipseRules.RULES_NONE,
                  "The document contains no invariant, so it checks nothing.",
                  SourceLocation.of(path))
              .withHint("Write one: context SoftwareNode inv HasName: name <> ''"));
    }
    return new Validation(new Coverage(List.of(path.toString()), 0, List.of()), found);
  }
}
