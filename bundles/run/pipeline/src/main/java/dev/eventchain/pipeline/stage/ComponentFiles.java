package dev.eventchain.pipeline.stage;

import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.SoftwareBase;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Python files of components: existing ones and those that a run writes. */
public final class ComponentFiles {

  /** Output folder of the components that did not exist. */
  public static final String FOLDER = "components";

  private ComponentFiles() {}

  /** Returns the file of a component that a run writes, relative to the output folder. */
  public static String name(String component) {
    return FOLDER + "/" + component + ".py";
  }

  /**
   * Returns the file of a component: from the software base, or else from a run.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if it does not exist and no run
   *     has written it
   */
  public static Path of(RunContext run, SoftwareNode node) {
    String name = name(node.getName());
    Optional<SoftwareBase.Component> existing = run.softwareBase().find(node.getName());
    Path written = run.file(name);
    if (existing.isEmpty() && !Files.isRegularFile(written)) {
      return run.required(name, Stage.IMPLEMENT);
    }
    return existing.map(SoftwareBase.Component::file).orElse(written);
  }
}
