package dev.eventchain.eclipse;

import dev.eventchain.check.EditorRules;
import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Metamodels;
import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.eclipse.content.ChainDescriber;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.xmi.XmiRules;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * A model outside of Eventchain projects.
 *
 * @param metamodels the metamodels of the Eclipse project, for models that are not event chains
 * @param rules the additional documents that are evaluated on it, if it is in no Eventchain project
 */
record ModelUnit(IFile file, Path path, List<Path> metamodels, List<Path> rules)
    implements CheckUnit {

  private static final Set<String> RELEVANT = Set.of("xmi", "eventchain", "ecore", "ocl");

  @Override
  public IResource subject() {
    return file;
  }

  /** Models may refer to others, and depend on metamodels and rules. */
  @Override
  public boolean dependsOn(IFile changed) {
    String kind = CheckedFiles.kind(changed);
    return kind.equals(CheckedFiles.kind(file)) || RELEVANT.contains(kind);
  }

  @Override
  public Validation check() {
    try {
      return validateChain();
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

  /**
   * Checks an event chain with the rules and messages of the Eventchain project that contains it,
   * if any.
   */
  private Validation validateChain() {
    Optional<ProjectFolder> folder =
        EventchainFolders.around(file).flatMap(CheckedFiles::pathOf).map(ProjectFolder::new);
    List<Path> documents =
        folder.map(ProjectFolder::ownConstraints).orElseGet(() -> aboutChains(rules));
    List<Path> messages = folder.map(ProjectFolder::messageFolders).orElse(List.of());
    return ModelValidation.validate(
        ModelFiles.of(List.of(path), List.of()), documents, messages, Preferences.timeLimit());
  }

  /** Returns the documents with constraints on event chains; the others use other metamodels. */
  private static List<Path> aboutChains(List<Path> documents) {
    return documents.stream().filter(FileChecks::isAboutChains).toList();
  }

  private Validation validate(List<Path> ecores, List<Path> documents) {
    return ModelValidation.validate(
        ModelFiles.of(List.of(path), ecores), documents, List.of(), Preferences.timeLimit());
  }

  /** An event chain of another version is an event chain, although its namespace is unknown. */
  private boolean isOfAnotherMetamodel(DiagnosticException e) {
    return e.diagnostics().stream().allMatch(each -> each.is(XmiRules.PACKAGE_UNKNOWN))
        && !ChainDescriber.isOfAnyVersion(path);
  }

  private Diagnostic unchecked() {
    return Diagnostic.of(
            EditorRules.MODEL_UNCHECKED,
            "The model was not checked: it is not an event chain, and its metamodel was not found.",
            SourceLocation.of(path))
        .withHint("Put the metamodel, an .ecore file, into the same project.");
  }
}
