package dev.eventchain.pipeline.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.llm.service.ModelServices;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.project.CatalogueSettings;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.project.RequirementSources;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * The content of {@code eventchain.yaml}.
 *
 * @param name the chain's name, from which that of the generated package is derived
 * @param title the title of the project; the name if not given
 * @param frequency Hz, for components whose description gives none
 * @param distribution the release of ROS 2 whose standard messages the chain uses
 * @param llm the default source of answers, see {@link dev.eventchain.llm.ModelAccess}
 * @param models the models for each task, by task: the first one is asked, the next one where it
 *     cannot be reached
 * @param services the locations and prices of models, and the spending limit of a run
 * @param repairs the number of times that failed checks are sent back to the model
 * @param requirements the sources of requirements besides {@code requirements.md}
 * @param catalogue the catalogue of signals, if there is one
 * @param template the folder of the template set, under templates/, or a file *.mtl of the project
 * @param strength the strength that requirements have to have
 * @param packageFacts the given metadata of the generated package, by template property, such as
 *     {@code package.license}
 */
public record Configuration(
    String name,
    String title,
    double frequency,
    RosDistribution distribution,
    String llm,
    Map<String, List<String>> models,
    ModelServices services,
    int repairs,
    RequirementSources requirements,
    Optional<CatalogueSettings> catalogue,
    String template,
    StrengthSettings strength,
    SortedMap<String, String> packageFacts) {

  /** Value for no language model. */
  public static final String DIRECT = "direct";

  private static final DocumentRules RULES = ProjectSettings.RULES;
  private static final String DEFAULT_MODEL = "person";
  private static final int DEFAULT_REPAIRS = 3;
  private static final NumberRange REPAIRS = NumberRange.of(0, 20);
  private static final String TEST = "test";
  private static final String IMPLEMENT = "implement";
  private static final String DIAGNOSE = "diagnose";
  private static final List<String> TASKS =
      List.of("design", TEST, IMPLEMENT, "model", "constrain", DIAGNOSE);
  private static final List<String> PACKAGE_FACTS = List.of("license", "maintainer", "email");

  /** Returns the JSON Schema of {@code eventchain.yaml}. */
  public static String schema() {
    return ResourceText.of(Configuration.class, "settings.schema.json");
  }

  /**
   * Reads the configuration.
   *
   * @param folder the folder of the project, which may contain its template
   * @throws DiagnosticException INPUT with all errors
   */
  static Configuration read(SourceText text, Path folder) {
    List<Diagnostic> problems = new ArrayList<>();
    Optional<Configuration> configuration =
        Document.parse(text, DocumentFormat.YAML, RULES, problems::add)
            .object("", problems::add)
            .map(settings -> read(settings, folder));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return configuration.orElseThrow();
  }

  private static Configuration read(ObjectReader settings, Path folder) {
    String name = ProjectSettings.name(settings);
    Configuration configuration =
        new Configuration(
            name,
            settings.text("title").orElse(name),
            ProjectSettings.frequency(settings),
            ProjectSettings.distribution(settings),
            settings.text("llm").orElse("replay"),
            settings.object("models").map(Configuration::models).orElse(Map.of()),
            ModelServices.read(settings),
            (int) settings.wholeNumber("repairs", REPAIRS).orElse(DEFAULT_REPAIRS),
            RequirementSources.read(settings, folder),
            CatalogueSettings.read(settings, folder),
            template(settings, folder),
            StrengthSettings.read(settings),
            settings.object("package").map(Configuration::facts).orElseGet(TreeMap::new));
    settings.refuseOthers();
    return configuration;
  }

  /** Checks the template's name before a language model is asked for the inputs of generation. */
  private static String template(ObjectReader settings, Path folder) {
    String template = settings.text("template").orElse(Templates.DEFAULT);
    if (!Templates.exists(folder, template)) {
      String sets = String.join(" or ", Templates.sets());
      settings.find(
          Diagnostic.of(
                  RULES.range(),
                  "There is no template set and no file '" + template + "'.",
                  settings.at("template"))
              .withHint("Use " + sets + ", or name a *.mtl file of the project."));
    }
    return template;
  }

  private static Map<String, List<String>> models(ObjectReader models) {
    SortedMap<String, List<String>> byTask = new TreeMap<>();
    for (String task : TASKS) {
      boolean several = models.value(task).filter(JsonNode::isArray).isPresent();
      if (several) {
        byTask.put(task, models.texts(task));
      } else if (models.has(task)) {
        byTask.put(task, List.of(models.requiredText(task)));
      }
      if (byTask.getOrDefault(task, List.of("one")).isEmpty()) {
        models.find(RULES.missing(), "'" + task + "' names no model.", models.at(task));
      }
    }
    models.refuseOthers();
    return byTask;
  }

  /** Returns the given metadata; templates have defaults for empty values. */
  private static SortedMap<String, String> facts(ObjectReader facts) {
    SortedMap<String, String> properties = new TreeMap<>();
    for (String fact : PACKAGE_FACTS) {
      if (facts.value(fact).isPresent()) {
        facts
            .text(fact)
            .filter(text -> !text.isBlank())
            .ifPresent(text -> properties.put("package." + fact, text));
      }
    }
    facts.refuseOthers();
    return properties;
  }

  /** Returns the settings of the chain itself. */
  public ProjectSettings settings() {
    return new ProjectSettings(name, frequency, distribution);
  }

  /**
   * Returns the models for a task in order of preference; the model for implementation also
   * proposes tests, and looks for what is wrong after a failed verdict, unless another one is
   * configured.
   */
  public List<String> models(String task) {
    boolean alsoImplements = task.equals(TEST) || task.equals(DIAGNOSE);
    List<String> usual = alsoImplements ? models(IMPLEMENT) : List.of(DEFAULT_MODEL);
    return models.getOrDefault(task, usual);
  }

  /** Returns a copy with one model for every task. */
  Configuration askingOnly(String model) {
    Map<String, List<String>> one = new TreeMap<>();
    TASKS.forEach(task -> one.put(task, List.of(model)));
    return new Configuration(
        name,
        title,
        frequency,
        distribution,
        llm,
        one,
        services,
        repairs,
        requirements,
        catalogue,
        template,
        strength,
        packageFacts);
  }

  /** Returns the language models of all tasks, in the order of the tasks. */
  public List<String> languageModels() {
    return TASKS.stream()
        .flatMap(task -> models(task).stream())
        .filter(model -> !model.equals(DIRECT))
        .distinct()
        .toList();
  }

  /** Passes on the names of the services of the models to ask. */
  public void services(Consumer<String> names) {
    Stream.concat(Stream.of(llm), models.values().stream().flatMap(List::stream))
        .filter(model -> model.contains("/"))
        .map(model -> model.substring(0, model.indexOf('/')))
        .filter(services.names()::contains)
        .forEach(names);
  }

  /** Returns whether runs ask services unless the command line says otherwise. */
  public boolean asksServices() {
    return llm.equals("live") || llm.equals("auto") || llm.contains("/");
  }
}
