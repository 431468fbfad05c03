package dev.eventchain.pipeline.stage;

import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.SoftwareBase;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The Python files of components: those that exist already, and those that a run writes. */
public final class ComponentFiles {

  /** The folder of the output with the components that did not exist. */
  public static final String FOLDER = "components";

  private ComponentFiles() {}

  /** The file of a component that a run writes, relative to the folder of the output. */
  public static String name(String component) {
    return FOLDER + "/" + component + ".py";
  }

  /**
   * The file of a component: from the software base, or else the one that a run wrote.
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
