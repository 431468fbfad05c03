package dev.eventchain.pipeline.project;

import dev.eventchain.project.ProjectFolder;
import dev.eventchain.simulation.bench.Bench;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A user's folder: where its files are, and what its configuration says. */
public final class Project extends ProjectFolder {

  private final Configuration configuration;
  private final boolean isEvaluated;

  private Project(Path folder, Configuration configuration, boolean isEvaluated) {
    super(folder);
    this.configuration = configuration;
    this.isEvaluated = isEvaluated;
  }

  /**
   * Opens a project.
   *
   * @param folder the folder that holds {@code eventchain.yaml}
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if it is not a project, or its
   *     configuration is not understood
   */
  public static Project open(Path folder) {
    Configuration read = Configuration.read(new ProjectFolder(folder).configurationText(), folder);
    return new Project(folder, read, false);
  }

  /**
   * The project as a run of an evaluation sees it: one model does every task, and designs a chain
   * of its own.
   */
  public Project evaluating(String model) {
    return new Project(folder(), configuration.askingOnly(model), true);
  }

  public Configuration configuration() {
    return configuration;
  }

  public Path recordings() {
    return folder().resolve("recordings");
  }

  /**
   * The chain that people edit, when there is one: then it is the source, unless language models
   * are evaluated, which then have a chain of their own to design.
   */
  @Override
  public Optional<Path> editedModel() {
    return isEvaluated ? Optional.empty() : super.editedModel();
  }

  /**
   * Whether there is a model that people edit; or one that an earlier run wrote, and the
   * constraints that stand for the design rules. A chain that people edit is not in need of a
   * language model: design rules without constraints are findings.
   *
   * @param output the folder of that run's results
   */
  public boolean isReadyToValidate(Path output) {
    boolean hasConstraints =
        designRules().isEmpty() || Files.isRegularFile(output.resolve(GENERATED));
    return editedModel().isPresent() || (model(output).isPresent() && hasConstraints);
  }

  /** As {@link #below}, none where there is no such folder. */
  public static List<Path> existingBelow(Path folder) {
    return Files.isDirectory(folder) ? below(folder) : List.of();
  }

  /** How the world and the chain are connected, where the project says so itself. */
  public Optional<Path> bench() {
    return existing(Bench.FILE);
  }

  /** The folder of the scenarios. */
  public Path scenarios() {
    return folder().resolve("scenarios");
  }

  /** Everything that people wrote and a run may read, but for recordings and the chain. */
  public List<Path> sources() {
    List<Path> files = new ArrayList<>(List.of(requirements(), designRulesFile()));
    files.addAll(ownConstraints());
    bench().ifPresent(files::add);
    for (String name : List.of("software-base", "scenarios", "tests")) {
      existing(name).filter(Files::isDirectory).ifPresent(each -> files.addAll(below(each)));
    }
    files.addAll(Templates.ownFiles(this));
    return files;
  }
}
