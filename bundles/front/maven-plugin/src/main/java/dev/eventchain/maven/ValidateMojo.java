package dev.eventchain.maven;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.pipeline.Outcome;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

/**
 * Checks models of any Ecore metamodel, or an event chain, with OCL, and fails the build if there
 * are errors.
 */
@Mojo(name = "validate", defaultPhase = LifecyclePhase.VERIFY, threadSafe = true)
public final class ValidateMojo extends ModelMojo {

  /** Complete OCL documents whose constraints the models must meet. */
  @Parameter private List<File> constraints = List.of();

  /** Folders of {@code PACKAGE/msg/NAME.msg} or {@code .idl} that models of event chains use. */
  @Parameter private List<File> messages = List.of();

  @Override
  Outcome work() {
    List<Outcome> parts = new ArrayList<>();
    chain().ifPresent(folder -> parts.add(guarded(() -> validate(folder))));
    nothingIn().ifPresent(parts::add);
    List<Path> models = models();
    if (!models.isEmpty()) {
      parts.add(guarded(() -> validate(models)));
    }
    return parts.stream()
        .reduce(Outcome::and)
        .orElseGet(
            () ->
                nothing(
                    List.of(
                        NothingToDo.finding(
                            "There is no model and no event chain to check.",
                            Optional.of(basedir())))));
  }

  private Outcome validate(List<Path> models) {
    Validation validation =
        ModelValidation.validate(
            new ModelFiles(models, metamodels(), references()),
            Places.shown(constraints),
            Places.shown(messages),
            timeLimit());
    return Outcome.of(validation.coverage(), validation.diagnostics(), suppressions());
  }
}
