package dev.eventchain.lsp.check;

import dev.eventchain.check.EditorRules;
import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Metamodels;
import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiRules;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/**
 * A model that is not the chain of a project: what {@code eventchain validate MODEL} checks.
 *
 * @param metamodels those that are near, for models that are not event chains
 * @param rules the documents that are near, which count if they are about these metamodels
 */
record ModelUnit(Path subject, List<Path> metamodels, List<Path> rules, Duration timeLimit)
    implements CheckUnit {

  @Override
  public List<Diagnostic> check() {
    try {
      return validate(List.of(), List.of());
    } catch (DiagnosticException e) {
      List<Path> sound = Metamodels.sound(metamodels);
      if (!isOfUnknownMetamodel(e)) {
        throw e;
      } else if (sound.isEmpty()) {
        return List.of(unchecked());
      }
      List<Path> about =
          rules.stream().filter(each -> FileChecks.isSound(each, Metamodels.of(sound))).toList();
      return validate(sound, about);
    }
  }

  private List<Diagnostic> validate(List<Path> ecores, List<Path> documents) {
    return ModelValidation.validate(
            ModelFiles.of(List.of(subject), ecores), documents, List.of(), timeLimit)
        .withoutNeedOfConstraints()
        .diagnostics();
  }

  private static boolean isOfUnknownMetamodel(DiagnosticException e) {
    return e.diagnostics().stream()
        .allMatch(each -> each.is(XmiRules.PACKAGE_UNKNOWN) && !isAboutChains(each));
  }

  /** An event chain of another version is an event chain, although its namespace is unknown. */
  private static boolean isAboutChains(Diagnostic unknown) {
    return unknown.message().contains(EventchainPackage.eNS_URI.replaceFirst("[^/]*$", ""));
  }

  private Diagnostic unchecked() {
    return Diagnostic.of(
            EditorRules.MODEL_UNCHECKED,
            "The model was not checked: it is not an event chain, and its metamodel was not found.",
            SourceLocation.of(subject))
        .withHint("Put the metamodel, an .ecore file, into the same folder.");
  }
}
