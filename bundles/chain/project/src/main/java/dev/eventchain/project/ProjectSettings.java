package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.RosDistribution;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Settings of the chain in {@code eventchain.yaml}; its other settings concern the runs.
 *
 * @param name the name of the chain and of the generated package
 * @param frequency Hz, for components whose description gives none
 * @param distribution the release of ROS 2 whose standard messages the chain uses
 */
public record ProjectSettings(String name, double frequency, RosDistribution distribution) {

  /** Ids of the findings about the file. */
  public static final DocumentRules RULES = DocumentRules.all(ProjectRules.PROJECT_CONFIGURATION);

  /** Default frequency in Hz. */
  public static final double DEFAULT_FREQUENCY = 20;

  /** The setting that names a release of ROS 2. */
  public static final String DISTRIBUTION = "ros_distro";

  private static final NumberRange FREQUENCIES = NumberRange.above(0).upTo(10_000);

  /**
   * Reads these settings of a project and ignores the others.
   *
   * @throws DiagnosticException INPUT if it is not a project ({@code project.missing}), its file
   *     cannot be read, or with every invalid setting ({@code project.configuration})
   */
  public static ProjectSettings read(ProjectFolder folder) {
    return read(
        folder,
        settings ->
            new ProjectSettings(name(settings), frequency(settings), distribution(settings)));
  }

  private static <T> T read(ProjectFolder folder, Function<ObjectReader, T> reader) {
    List<Diagnostic> problems = new ArrayList<>();
    Optional<T> read =
        Document.parse(folder.configurationText(), DocumentFormat.YAML, RULES, problems::add)
            .object("", problems::add)
            .map(reader);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return read.orElseThrow();
  }

  /** As {@link #read(ProjectFolder)}, but only the release of ROS 2. */
  static RosDistribution distribution(ProjectFolder folder) {
    return read(folder, ProjectSettings::distribution);
  }

  /** As {@link #read(ProjectFolder)}, but only the sources of requirements. */
  static RequirementSources requirements(ProjectFolder folder) {
    return read(folder, settings -> RequirementSources.read(settings, folder.folder()));
  }

  /** As {@link #read(ProjectFolder)}, but only the catalogue of signals, if there is one. */
  static Optional<CatalogueSettings> catalogue(ProjectFolder folder) {
    return read(folder, settings -> CatalogueSettings.read(settings, folder.folder()));
  }

  /** Returns the required name; the reader reports an invalid one. */
  public static String name(ObjectReader settings) {
    String name = settings.requiredText("name");
    if (!name.isBlank() && !name.matches("[a-z][a-z0-9_]*")) {
      String message = "'" + name + "' cannot be the name of a ROS 2 package.";
      settings.find(
          Diagnostic.of(RULES.range(), message, settings.at("name"))
              .withHint("Use lower-case letters, digits and underscores, a letter first."));
    }
    return name;
  }

  /** Returns the frequency in Hz, 20 if not given; the reader reports an invalid one. */
  public static double frequency(ObjectReader settings) {
    return settings.number("frequency", FREQUENCIES).orElse(DEFAULT_FREQUENCY);
  }

  /** Returns the release of ROS 2, the default one if not given; the reader reports others. */
  public static RosDistribution distribution(ObjectReader settings) {
    return settings
        .text(DISTRIBUTION)
        .map(id -> RosDistribution.of(id).orElseGet(() -> unknown(id, settings)))
        .orElse(RosDistribution.DEFAULT);
  }

  private static RosDistribution unknown(String id, ObjectReader settings) {
    String message = "The messages of ROS 2 '" + id + "' are not known.";
    String known = String.join(" or ", RosDistribution.ids());
    settings.find(
        Diagnostic.of(RULES.range(), message, settings.at(DISTRIBUTION))
            .withHint(
                "Use " + known + ", and put definitions that differ into software-base/msg."));
    return RosDistribution.DEFAULT;
  }
}
