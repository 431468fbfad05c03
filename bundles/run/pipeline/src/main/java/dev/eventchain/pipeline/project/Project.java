package dev.eventchain.pipeline.project;

import dev.eventchain.messages.RosDistribution;
import dev.eventchain.project.CatalogueSettings;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.RequirementSources;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A user's project folder: its files and its configuration. */
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
   *     configuration is invalid
   */
  public static Project open(Path folder) {
    Configuration read = Configuration.read(new ProjectFolder(folder).configurationText(), folder);
    return new Project(folder, read, false);
  }

  /**
   * Returns the project for a run of an evaluation: one model does every task, and designs its own
   * chain.
   */
  public Project evaluating(String model) {
    return new Project(folder(), configuration.askingOnly(model), true);
  }

  public Configuration configuration() {
    return configuration;
  }

  /** Returns the release of ROS 2 as it was read with the rest of the configuration. */
  @Override
  public RosDistribution distribution() {
    return configuration.distribution();
  }

  /** Returns the sources of requirements as they were read with the rest of the configuration. */
  @Override
  public RequirementSources requirementSources() {
    return configuration.requirements();
  }

  /** Returns the catalogue of signals as it was read with the rest of the configuration. */
  @Override
  public Optional<CatalogueSettings> catalogue() {
    return configuration.catalogue();
  }

  public Path recordings() {
    return folder().resolve(ProjectLayout.RECORDINGS);
  }

  /**
   * Returns the edited chain, if there is one: it is the source, except in an evaluation, where
   * language models design the chain.
   */
  @Override
  public Optional<Path> editedModel() {
    return isEvaluated ? Optional.empty() : super.editedModel();
  }

  /**
   * Returns whether there is a model that people edit, or one from an earlier run with the
   * constraints for the design rules. An edited chain needs no language model: design rules without
   * constraints are findings.
   *
   * @param output the folder of that run's results
   */
  public boolean isReadyToValidate(Path output) {
    boolean hasConstraints =
        designRules().isEmpty() || Files.isRegularFile(output.resolve(GENERATED));
    return editedModel().isPresent() || (model(output).isPresent() && hasConstraints);
  }

  /** As {@link #below}; empty if the folder does not exist. */
  public static List<Path> existingBelow(Path folder) {
    return Files.isDirectory(folder) ? below(folder) : List.of();
  }

  /** Returns the connections between world and chain, if the project defines them itself. */
  public Optional<Path> bench() {
    return existing(ProjectLayout.BENCH);
  }

  /** Returns the project's own file of faults, if there is one; others are named by options. */
  public Optional<Path> faults() {
    return existing(ProjectLayout.FAULTS);
  }

  /** Returns the folder of the scenarios. */
  public Path scenarios() {
    return folder().resolve(ProjectLayout.SCENARIOS);
  }

  /** Returns all handwritten files that a run may read, except recordings and the chain. */
  public List<Path> sources() {
    List<Path> files = new ArrayList<>(requirementFiles());
    files.add(designRulesFile());
    files.addAll(ownConstraints());
    bench().ifPresent(files::add);
    catalogue().ifPresent(it -> files.addAll(it.source().files()));
    for (String name :
        List.of(ProjectLayout.SOFTWARE_BASE, ProjectLayout.SCENARIOS, ProjectLayout.TESTS)) {
      existing(name).filter(Files::isDirectory).ifPresent(each -> files.addAll(below(each)));
    }
    files.addAll(Templates.ownFiles(this));
    return files;
  }
}
