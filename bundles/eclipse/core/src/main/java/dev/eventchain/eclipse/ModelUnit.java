package dev.eventchain.eclipse;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.validation.ModelValidation;
import dev.eventchain.validation.Validation;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * A model that stands for itself.
 *
 * @param metamodels those of the Eclipse project, which it is checked with if it is no event chain
 * @param rules the documents that are then evaluated besides what the metamodels say
 */
record ModelUnit(IFile file, Path path, List<Path> metamodels, List<Path> rules)
    implements CheckUnit {

  /** The beginning of our namespaces: a model of another version is an event chain all the same. */
  private static final String OURS = "http://eventchain.dev/";

  private static final Set<String> RELEVANT = Set.of("xmi", "eventchain", "ecore", "ocl");

  @Override
  public IResource subject() {
    return file;
  }

  /** Models may refer to others, and are what metamodels and rules say. */
  @Override
  public boolean dependsOn(IFile changed) {
    return changed.equals(file) || RELEVANT.contains(String.valueOf(changed.getFileExtension()));
  }

  @Override
  public Validation check() {
    try {
      return validate(List.of(), List.of());
    } catch (DiagnosticException e) {
      if (!isOfAnotherMetamodel(e)) {
        throw e;
      }
    }
    List<Path> sound = Metamodels.sound(metamodels);
    return sound.isEmpty()
        ? new Validation(Coverage.NONE, List.of(unchecked()))
        : validate(sound, rules);
  }

  private Validation validate(List<Path> ecores, List<Path> documents) {
    return ModelValidation.validate(
        ecores, Map.of(), documents, List.of(path), List.of(), Preferences.timeLimit());
  }

  private static boolean isOfAnotherMetamodel(DiagnosticException e) {
    return e.diagnostics().stream()
        .allMatch(
            each -> each.id().equals("xmi.package.unknown") && !each.message().contains(OURS));
  }

  private Diagnostic unchecked() {
    return Diagnostic.info(
            "eclipse.model.unchecked",
            "The model was not checked: it is no event chain, and its metamodel is not here.",
            SourceLocation.of(path))
        .withHint("Put the metamodel, an .ecore file, into the same project.");
  }
}
