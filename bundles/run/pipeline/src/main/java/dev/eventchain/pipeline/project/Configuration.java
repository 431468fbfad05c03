package dev.eventchain.pipeline.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.FindingIds;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.llm.service.ModelServices;
import dev.eventchain.project.ProjectSettings;
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
 * What {@code eventchain.yaml} says.
 *
 * @param name the chain's name, after which the generated package is called
 * @param title what people call the project; the name if not given
 * @param frequency Hz, for components whose description gives none
 * @param llm how answers are had when the command line does not say, as {@link
 *     dev.eventchain.llm.ModelAccess} has it
 * @param models the models for each task, by task: the first one is asked, the next one where it
 *     cannot be reached
 * @param services where models are, what they cost, and what a run may cost
 * @param repairs how often a failed check goes back to the model
 * @param template the folder of the template set, under templates/, or a file *.mtl of the project
 * @param packageFacts what the generated package says of itself, by the properties that templates
 *     get: {@code package.license} and so on; only what is given
 */
public record Configuration(
    String name,
    String title,
    double frequency,
    String llm,
    Map<String, List<String>> models,
    ModelServices services,
    int repairs,
    String template,
    SortedMap<String, String> packageFacts) {

  /** Stands for no language model. */
  public static final String DIRECT = "direct";

  private static final FindingIds IDS = ProjectSettings.IDS;
  private static final String DEFAULT_MODEL = "person";
  private static final int DEFAULT_REPAIRS = 3;
  private static final NumberRange REPAIRS = NumberRange.of(0, 20);
  private static final String TEST = "test";
  private static final String IMPLEMENT = "implement";
  private static final List<String> TASKS =
      List.of("design", TEST, IMPLEMENT, "model", "constrain");
  private static final List<String> PACKAGE_FACTS = List.of("license", "maintainer", "email");

  /**
   * Reads the configuration.
   *
   * @param folder that of the project, in which its template may be
   * @throws DiagnosticException INPUT with everything that is not understood
   */
  static Configuration read(SourceText text, Path folder) {
    List<Diagnostic> problems = new ArrayList<>();
    Optional<Configuration> configuration =
        Document.parse(text, DocumentFormat.YAML, IDS, problems::add)
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
            settings.text("llm").orElse("replay"),
            settings.object("models").map(Configuration::models).orElse(Map.of()),
            ModelServices.read(settings),
            (int) settings.wholeNumber("repairs", REPAIRS).orElse(DEFAULT_REPAIRS),
            template(settings, folder),
            settings.object("package").map(Configuration::facts).orElseGet(TreeMap::new));
    settings.refuseOthers();
    return configuration;
  }

  /** A wrong one is said before a language model is asked for what it would generate from. */
  private static String template(ObjectReader settings, Path folder) {
    String template = settings.text("template").orElse(Templates.DEFAULT);
    if (!Templates.exists(folder, template)) {
      String sets = String.join(" or ", Templates.sets());
      settings.find(
          Diagnostic.error(
                  IDS.range(),
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
        models.find(IDS.missing(), "'" + task + "' names no model.", models.at(task));
      }
    }
    models.refuseOthers();
    return byTask;
  }

  /** What is left empty is not said; the templates have something of their own to say then. */
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

  /** What it says of the chain itself. */
  public ProjectSettings settings() {
    return new ProjectSettings(name, frequency);
  }

  /**
   * The models for a task, the one that is wanted first; who implements also proposes tests where
   * nobody else is to.
   */
  public List<String> models(String task) {
    List<String> usual = task.equals(TEST) ? models(IMPLEMENT) : List.of(DEFAULT_MODEL);
    return models.getOrDefault(task, usual);
  }

  /** The same, with one model for every task. */
  Configuration askingOnly(String model) {
    Map<String, List<String>> one = new TreeMap<>();
    TASKS.forEach(task -> one.put(task, List.of(model)));
    return new Configuration(
        name, title, frequency, llm, one, services, repairs, template, packageFacts);
  }

  /** The language models that are named for any task, in the order of the tasks. */
  public List<String> languageModels() {
    return TASKS.stream()
        .flatMap(task -> models(task).stream())
        .filter(model -> !model.equals(DIRECT))
        .distinct()
        .toList();
  }

  /** Names the services of the models that are to be asked. */
  public void services(Consumer<String> names) {
    Stream.concat(Stream.of(llm), models.values().stream().flatMap(List::stream))
        .filter(model -> model.contains("/"))
        .map(model -> model.substring(0, model.indexOf('/')))
        .filter(services.names()::contains)
        .forEach(names);
  }

  /** Whether runs ask services if the command line does not say otherwise. */
  public boolean asksServices() {
    return llm.equals("live") || llm.equals("auto") || llm.contains("/");
  }
}
