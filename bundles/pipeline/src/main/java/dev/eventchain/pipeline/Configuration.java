package dev.eventchain.pipeline;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What {@code eventchain.yaml} says.
 *
 * @param name the chain's name, after which the generated package is called
 * @param title what people call the project; the name if not given
 * @param frequency Hz, for components whose description gives none
 * @param llm how answers are had when the command line does not say: {@code replay} or {@code
 *     handoff:DIR}
 * @param models the model for each task, by task
 * @param repairs how often a failed check goes back to the model
 * @param template the folder of the template set, under templates/
 * @param packageFacts what the generated package says of itself, by the properties that templates
 *     get: {@code package.license} and so on; only what is given
 */
record Configuration(
    String name,
    String title,
    double frequency,
    String llm,
    Map<String, String> models,
    int repairs,
    String template,
    SortedMap<String, String> packageFacts) {

  private static final double DEFAULT_FREQUENCY = 20;
  private static final String DEFAULT_MODEL = "person";
  private static final int DEFAULT_REPAIRS = 3;
  private static final int MOST_REPAIRS = 20;
  private static final List<String> TASKS = List.of("design", "implement", "model", "constrain");

  /** What each setting holds, in words. */
  private static final Map<String, String> KINDS =
      Map.of(
          "name", "a text",
          "title", "a text",
          "frequency", "a number in Hz",
          "llm", "a text",
          "models", "a mapping from tasks to models",
          "repairs", "a whole number",
          "template", "a text",
          "package", "a mapping with texts for license, maintainer and email");

  private static final ObjectMapper YAML =
      YAMLMapper.builder()
          .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
          .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
          .build();

  /** The file as it is written: everything optional but the name. */
  private record Document(
      @JsonProperty("name") String name,
      @JsonProperty("title") String title,
      @JsonProperty("frequency") Double frequency,
      @JsonProperty("llm") String llm,
      @JsonProperty("models") Map<String, String> models,
      @JsonProperty("repairs") Integer repairs,
      @JsonProperty("template") String template,
      @JsonProperty("package") PackageFacts packageFacts) {}

  private record PackageFacts(
      @JsonProperty("license") String license,
      @JsonProperty("maintainer") String maintainer,
      @JsonProperty("email") String email) {

    private SortedMap<String, String> properties() {
      SortedMap<String, String> properties = new TreeMap<>();
      put(properties, "license", license);
      put(properties, "maintainer", maintainer);
      put(properties, "email", email);
      return properties;
    }

    private static void put(SortedMap<String, String> properties, String name, String value) {
      if (value != null && !value.isBlank()) {
        properties.put("package." + name, value);
      }
    }
  }

  /**
   * Reads the configuration.
   *
   * @throws DiagnosticException INPUT for anything that is not understood
   */
  static Configuration read(SourceText text) {
    Document document = parse(text);
    Configuration configuration =
        new Configuration(
            required(document.name, "name", text),
            document.title == null ? document.name : document.title,
            document.frequency == null ? DEFAULT_FREQUENCY : document.frequency,
            document.llm == null ? "replay" : document.llm,
            document.models == null ? Map.of() : new TreeMap<>(document.models),
            document.repairs == null ? DEFAULT_REPAIRS : document.repairs,
            document.template == null ? "ros2-python" : document.template,
            document.packageFacts == null ? new TreeMap<>() : document.packageFacts.properties());
    configuration.check(text);
    return configuration;
  }

  private static Document parse(SourceText text) {
    if (text.text().isBlank()) {
      throw invalid("The file is empty.", whole(text), "It needs at least `name: ...`.");
    }
    try {
      return YAML.readValue(text.text(), Document.class);
    } catch (UnrecognizedPropertyException e) {
      throw invalid(
          "There is no setting '" + e.getPropertyName() + "'.",
          at(text, e.getPropertyName()),
          "The settings are " + String.join(", ", new TreeSet<>(known(e))) + ".");
    } catch (JsonMappingException e) {
      String setting = e.getPath().isEmpty() ? "" : e.getPath().get(0).getFieldName();
      throw setting == null || !KINDS.containsKey(setting)
          ? invalid(firstLine(e.getOriginalMessage()), at(text, e.getLocation()), "")
          : invalid(
              "The setting '" + setting + "' must be " + KINDS.get(setting) + ".",
              at(text, setting),
              "");
    } catch (JsonProcessingException e) {
      throw invalid(firstLine(e.getOriginalMessage()), at(text, e.getLocation()), "");
    }
  }

  private static List<String> known(UnrecognizedPropertyException e) {
    return e.getKnownPropertyIds().stream().map(String::valueOf).toList();
  }

  private static String firstLine(String message) {
    return message.lines().findFirst().orElse("The file is not YAML.");
  }

  private void check(SourceText text) {
    if (!name.matches("[a-z][a-z0-9_]*")) {
      throw invalid(
          "'" + name + "' cannot be the name of a ROS 2 package.",
          at(text, "name"),
          "Use lower-case letters, digits and underscores, a letter first.");
    }
    if (!(frequency > 0 && frequency <= 10_000)) {
      throw invalid(
          "The frequency must be above 0 and at most 10000 Hz, not " + frequency + ".",
          at(text, "frequency"),
          "");
    }
    if (repairs < 0 || repairs > MOST_REPAIRS) {
      throw invalid(
          "repairs must be from 0 to " + MOST_REPAIRS + ", not " + repairs + ".",
          at(text, "repairs"),
          "");
    }
    for (String task : models.keySet()) {
      if (!TASKS.contains(task)) {
        throw invalid(
            "There is no task '" + task + "' to give a model to.",
            at(text, task),
            "The tasks are " + String.join(", ", TASKS) + ".");
      }
    }
  }

  /** The model that a stage asks. */
  String model(Stage stage) {
    return models.getOrDefault(stage.id(), DEFAULT_MODEL);
  }

  private static String required(String value, String setting, SourceText text) {
    if (value == null || value.isBlank()) {
      throw invalid("The setting '" + setting + "' is missing.", whole(text), "");
    }
    return value;
  }

  private static SourceLocation whole(SourceText text) {
    return SourceLocation.of(text.name());
  }

  /** The first line that gives a setting a value; the whole file if there is none. */
  private static SourceLocation at(SourceText text, String setting) {
    Matcher line =
        Pattern.compile("(?m)(?:^|[{,]\\s*)[ \"']*(" + Pattern.quote(setting) + ")[\"']?\\s*:")
            .matcher(text.text());
    return line.find() ? text.at(line.start(1)) : whole(text);
  }

  private static SourceLocation at(SourceText text, JsonLocation location) {
    return location == null || location.getLineNr() < 1
        ? whole(text)
        : text.at(location.getLineNr(), location.getColumnNr());
  }

  private static DiagnosticException invalid(String message, SourceLocation location, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("project.configuration", message, location).withHint(hint));
  }
}
