package dev.eventchain.project;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosDistribution;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** A user's project folder: paths of its files, and of those results that are checked. */
public class ProjectFolder {

  /** Name of the chain description among the results of a run. */
  public static final String DESCRIPTION = "chain.json";

  /** Name of the chain model among the results of a run. */
  public static final String MODEL = "chain.xmi";

  /** Name of the constraints for the design rules among the results of a run. */
  public static final String GENERATED = "generated.ocl";

  private final Path folder;

  /**
   * Creates a project folder without reading it.
   *
   * @param folder the folder that holds {@code eventchain.yaml}
   */
  public ProjectFolder(Path folder) {
    this.folder = folder;
  }

  /** Returns the nearest project whose folder holds a file, directly or further down. */
  public static Optional<ProjectFolder> around(Path file) {
    for (Path above = file.toAbsolutePath().normalize().getParent();
        above != null;
        above = above.getParent()) {
      ProjectFolder project = new ProjectFolder(above);
      if (Files.isRegularFile(project.configurationFile())) {
        return Optional.of(project);
      }
    }
    return Optional.empty();
  }

  /** Returns the folder. */
  public final Path folder() {
    return folder;
  }

  /** Returns the configuration file, which identifies a project. */
  public final Path configurationFile() {
    return folder.resolve(ProjectLayout.CONFIGURATION);
  }

  /**
   * Returns the text of the configuration.
   *
   * @throws DiagnosticException INPUT if it is not a project ({@code project.missing}), the file
   *     cannot be read, or the case of another file name is wrong ({@code project.file.misnamed})
   */
  public final SourceText configurationText() {
    if (!Files.isDirectory(folder)) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
              ProjectRules.PROJECT_MISSING, "There is no such folder.", SourceLocation.of(folder)));
    }
    if (!Files.exists(configurationFile())) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  ProjectRules.PROJECT_MISSING,
                  "The folder is not a project: it contains no eventchain.yaml.",
                  SourceLocation.of(folder))
              .withHint(
                  ProjectFileNames.misspelt(configurationFile())
                      .map(
                          name -> "Rename '" + name + "' to '" + ProjectLayout.CONFIGURATION + "'.")
                      .orElse(
                          "Name the folder of a project, for example examples/aeb; 'eventchain"
                              + " init' starts one. Model files are named one by one.")));
    }
    ProjectFileNames.refuseOtherCase(folder);
    return SourceText.read(configurationFile());
  }

  /** Returns the file of suppressions, if there is one. */
  public final Optional<Path> suppressions() {
    return Optional.of(suppressionsFile()).filter(file -> !isAbsent(file));
  }

  /** Returns the file of suppressions, which may be absent. */
  public final Path suppressionsFile() {
    return folder.resolve(ProjectLayout.SUPPRESSIONS);
  }

  /** Returns the file of accepted texts of requirements, which may be absent. */
  public final Path acceptedFile() {
    return folder.resolve(ProjectLayout.ACCEPTED);
  }

  /** Returns the accepted texts of requirements, if the project keeps any. */
  public final Optional<AcceptedTexts> accepted() {
    return isAbsent(acceptedFile())
        ? Optional.empty()
        : Optional.of(AcceptedTexts.read(acceptedFile()));
  }

  /** Returns the default output folder. */
  public final Path defaultOutput() {
    return folder.resolve(ProjectLayout.OUTPUT);
  }

  /**
   * Returns the command that runs the project.
   *
   * @param output the folder of its results
   * @param more further arguments; may be empty
   */
  public final String command(Path output, String more) {
    boolean usual = output.equals(defaultOutput());
    return "eventchain run "
        + folder
        + (usual ? "" : " -o " + output)
        + (more.isEmpty() ? "" : " " + more);
  }

  /** Returns the file of functional requirements in Markdown, which may be absent. */
  public final Path requirements() {
    return folder.resolve(ProjectLayout.REQUIREMENTS);
  }

  /**
   * Returns the files and folders of requirements that the configuration names.
   *
   * @throws DiagnosticException INPUT if the configuration cannot be read
   */
  public RequirementSources requirementSources() {
    return ProjectSettings.requirements(this);
  }

  /** Returns whether the project has requirements: a file in Markdown, or named sources. */
  public final boolean hasRequirements() {
    return !isAbsent(requirements()) || !requirementSources().isEmpty();
  }

  /**
   * Returns the files that the requirements are read from, which need not exist.
   *
   * @throws DiagnosticException INPUT if a folder or the configuration cannot be read
   */
  public final List<Path> requirementFiles() {
    List<Path> sources = requirementSources().files();
    return Stream.concat(Stream.of(requirements()), sources.stream()).distinct().toList();
  }

  /** Returns the first file or folder of requirements, where findings about all of them belong. */
  public final Path firstRequirements() {
    return isAbsent(requirements())
        ? requirementSources().named().stream().findFirst().orElse(requirements())
        : requirements();
  }

  /** Returns a place with its line, from the folder if it is inside: {@code requirements.md:3}. */
  public final String placeOf(SourceLocation location) {
    String inside = SourceLocation.of(folder).file() + "/";
    String file = location.file();
    String shown = file.startsWith(inside) ? file.substring(inside.length()) : file;
    return location.line() > 0 ? shown + ":" + location.line() : shown;
  }

  /**
   * Reads the requirements of all sources.
   *
   * @throws DiagnosticException INPUT if one cannot be read, or with all findings if any is an
   *     error
   */
  public final Requirements readRequirements() {
    RequirementSources sources = requirementSources();
    boolean onlySources =
        (isAbsent(requirements()) && !sources.isEmpty()) || sources.has(requirements());
    Optional<SourceText> markdown =
        onlySources ? Optional.empty() : Optional.of(SourceText.read(requirements()));
    Requirements all = Requirements.read(markdown, sources);
    refuseErrors(all.diagnostics());
    return all;
  }

  /** Returns the file of design rules, if it exists. */
  public final Optional<Path> designRules() {
    return existing(ProjectLayout.DESIGN_RULES);
  }

  /** Returns the file of design rules, which may be absent. */
  public final Path designRulesFile() {
    return folder.resolve(ProjectLayout.DESIGN_RULES);
  }

  /** Returns the folder of the software base. */
  public final Path softwareBase() {
    return folder.resolve(ProjectLayout.SOFTWARE_BASE);
  }

  /** Returns the file that describes the existing components, which may be absent. */
  public final Path componentsFile() {
    return folder.resolve(ProjectLayout.COMPONENTS);
  }

  /** Returns the files that describe the software base, which may be absent. */
  public final List<Path> softwareBaseFiles() {
    return Stream.concat(Stream.of(componentsFile()), signalFiles().stream()).toList();
  }

  /** Returns the files of the vehicle's signals, without what they include. */
  public final List<Path> signalFiles() {
    Stream<Path> others = catalogue().stream().flatMap(it -> it.source().files().stream());
    return Stream.concat(Stream.of(folder.resolve(ProjectLayout.SIGNALS)), others).toList();
  }

  /** Returns the catalogue of signals that the configuration names, which has to be readable. */
  public Optional<CatalogueSettings> catalogue() {
    return ProjectSettings.catalogue(this);
  }

  /** Returns the file of open questions about the software base, which may be absent. */
  public final Path questionsFile() {
    return folder.resolve(ProjectLayout.QUESTIONS);
  }

  /** Returns the edited chain model, if there is one; then it is the source. */
  public Optional<Path> editedModel() {
    return existing(ProjectLayout.MODEL);
  }

  /** Returns the chain model: the edited one, otherwise the one of an earlier run. */
  public final Optional<Path> model(Path output) {
    return editedModel().or(() -> Optional.of(output.resolve(MODEL)).filter(Files::isRegularFile));
  }

  /** Returns the document of constraints written by users, which may be absent. */
  public final Path constraintsFile() {
    return folder.resolve(ProjectLayout.CONSTRAINTS);
  }

  /** Returns the documents of constraints written by users, and their imports. */
  public final List<Path> ownConstraints() {
    return OclRules.files(existing(ProjectLayout.CONSTRAINTS).stream().toList());
  }

  /**
   * Returns the documents of rules that are checked together with one although none imports the
   * other: both of a project for each of them, and any other document alone.
   */
  public static Set<Path> checkedTogether(Path document) {
    return around(document)
        .map(it -> Set.of(it.constraintsFile(), it.defaultOutput().resolve(GENERATED)))
        .filter(together -> together.contains(document))
        .orElse(Set.of(document));
  }

  /** Returns the constraints generated by an earlier run, if there are any. */
  public final Optional<Path> generated(Path output) {
    return Optional.of(output.resolve(GENERATED)).filter(file -> !isAbsent(file));
  }

  /**
   * Returns the files with the project's constraints, without the standard ones.
   *
   * @param output the folder of the project's results, which may hold generated constraints
   */
  public final List<Path> constraintFiles(Path output) {
    return Stream.concat(ownConstraints().stream(), generated(output).stream()).toList();
  }

  /** As {@link #constraintFiles}, as displayed names. */
  public final List<String> constraintNames(Path output) {
    return constraintFiles(output).stream().map(file -> SourceLocation.of(file).file()).toList();
  }

  /** Returns the folders with {@code <package>/msg/*.msg}. */
  public final List<Path> messageFolders() {
    Optional<Path> messages = existing(ProjectLayout.MESSAGES);
    messages.filter(each -> !Files.isDirectory(each)).ifPresent(ProjectFolder::refuseNoFolder);
    return messages.map(List::of).orElse(List.of());
  }

  /**
   * Returns the release of ROS 2 whose standard messages the project uses.
   *
   * @throws DiagnosticException INPUT if the configuration cannot be read, or names an unknown one
   */
  public RosDistribution distribution() {
    return ProjectSettings.distribution(this);
  }

  /** Returns the files in the message folders. */
  public final List<Path> messageFiles() {
    return messageFolders().stream().flatMap(each -> below(each).stream()).toList();
  }

  /**
   * Reads requirements or design rules.
   *
   * @throws DiagnosticException INPUT if the file cannot be read, or with its findings if any is an
   *     error
   */
  public static Requirements readRules(Path file) {
    Requirements read = Requirements.read(SourceText.read(file));
    refuseErrors(read.diagnostics());
    return read;
  }

  /**
   * Returns a finding if there are no written requirements although something names one: people
   * could read nowhere what is proved.
   *
   * @param named the ids of requirements that the chain or the scenarios name, in order
   */
  public final Optional<Diagnostic> missingRequirements(Collection<String> named) {
    return named.stream()
        .filter(Objects::nonNull)
        .findFirst()
        .filter(id -> !hasRequirements())
        .map(id -> Requirements.missing(requirements(), id));
  }

  /**
   * Reads the software base.
   *
   * @throws DiagnosticException INPUT with the findings if any is an error
   */
  public final SoftwareBase readSoftwareBase() {
    SoftwareBase base = SoftwareBase.read(softwareBase(), catalogue());
    refuseErrors(base.diagnostics());
    return base;
  }

  /**
   * Reads the message definitions, the standard ones and the project's own.
   *
   * @throws DiagnosticException INPUT with the findings if any is an error
   */
  public final MessageCatalog readMessages() {
    MessageCatalog messages = MessageCatalog.of(distribution(), messageFolders());
    refuseErrors(messages.diagnostics());
    return messages;
  }

  static void refuseErrors(List<Diagnostic> diagnostics) {
    if (Diagnostic.anyError(diagnostics)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, diagnostics);
    }
  }

  /**
   * Returns the files in and below a folder, without compiled Python files. Links are followed, but
   * not into folders that they are in.
   *
   * @throws DiagnosticException INPUT if it, or a folder in it, cannot be read
   */
  public static List<Path> below(Path folder) {
    try {
      return FilesBelow.list(folder);
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    }
  }

  /** Returns a file or folder of the project, unless it is certainly absent. */
  protected final Optional<Path> existing(String name) {
    return Optional.of(folder.resolve(name)).filter(file -> !isAbsent(file));
  }

  /**
   * Returns whether a file is certainly absent. Broken links, folders and inaccessible files are
   * present; reading them reports the problem.
   */
  public static boolean isAbsent(Path file) {
    return Files.notExists(file, LinkOption.NOFOLLOW_LINKS);
  }

  private static void refuseNoFolder(Path path) {
    throw FileRules.refusal("The path", path, new NotDirectoryException(path.toString()));
  }
}
