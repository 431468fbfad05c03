package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.Nulls;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonDeserializer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.introspect.Annotated;
import com.fasterxml.jackson.databind.introspect.AnnotatedMember;
import com.fasterxml.jackson.databind.introspect.JacksonAnnotationIntrospector;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.Set;

/**
 * Reads and writes results as JSON. Reading is strict: an unknown, missing or repeated key is an
 * error, since a value read as false or empty could pass for a result. Only what is optional, or
 * omitted where it is empty, may be missing.
 */
public final class ResultJson {

  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .annotationIntrospector(new RequiredUnlessOmitted())
          .addModule(OptionalValues.module())
          .addModule(new SimpleModule().addDeserializer(Rule.Trait.class, new TraitReader()))
          .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .disable(SerializationFeature.FAIL_ON_EMPTY_BEANS)
          .build();

  static {
    OptionalValues.TYPES.forEach(
        type ->
            MAPPER
                .configOverride(type)
                .setInclude(JsonInclude.Value.construct(JsonInclude.Include.NON_EMPTY, null)));
  }

  private ResultJson() {}

  /** Returns the JSON of a value, in one line. */
  public static byte[] bytes(Object value) {
    try {
      return MAPPER.writeValueAsBytes(value);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a result is plain data", e);
    }
  }

  /** Returns the JSON of a value for people to read. */
  public static byte[] indented(Object value) {
    DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter);
    try {
      String text = new ObjectMapper().writer(printer).writeValueAsString(tree(value)) + "\n";
      return text.getBytes(StandardCharsets.UTF_8);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a result is plain data", e);
    }
  }

  /** Returns the JSON of a value as a tree. */
  public static JsonNode tree(Object value) {
    return MAPPER.valueToTree(value);
  }

  /**
   * Reads a value.
   *
   * @throws IOException if the bytes are not exactly such a value
   */
  public static <T> T read(byte[] json, Class<T> type) throws IOException {
    return present(MAPPER.readValue(json, type));
  }

  /**
   * Reads a value without which work is done again; empty if the bytes are not exactly such a
   * value, but a broken one or that of another version of this program.
   */
  public static <T> Optional<T> ifValid(byte[] json, Class<T> type) {
    try {
      return Optional.of(read(json, type));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /**
   * Reads a value that holds the report of a stage.
   *
   * @throws IOException if the bytes are not exactly such a value
   */
  public static <T> T read(byte[] json, Class<T> type, Stage stage) throws IOException {
    SimpleModule reports =
        new SimpleModule().addDeserializer(StageReport.class, new ReportReader(stage));
    return present(MAPPER.rebuild().addModule(reports).build().readValue(json, type));
  }

  /** Refuses {@code null}, which Jackson takes for a value of any type. */
  private static <T> T present(T value) throws IOException {
    if (value == null) {
      throw new IOException("It is null.");
    }
    return value;
  }

  /** Reads the report of a stage, whose type follows from the stage. */
  private static final class ReportReader extends JsonDeserializer<StageReport> {

    private final Class<? extends StageReport> type;
    private final boolean mayBeNone;

    ReportReader(Stage stage) {
      type =
          switch (stage) {
            case DESIGN, IMPLEMENT, MODEL, CONSTRAIN -> Answers.class;
            case VALIDATE -> Validated.class;
            case SIMULATE -> Simulated.class;
            case GENERATE, REPORT -> StageReport.None.class;
          };
      mayBeNone = !Set.of(Stage.VALIDATE, Stage.SIMULATE).contains(stage);
    }

    @Override
    public StageReport deserialize(JsonParser parser, DeserializationContext context)
        throws IOException {
      JsonNode report = context.readTree(parser);
      return mayBeNone && report.isObject() && report.isEmpty()
          ? new StageReport.None()
          : context.readTreeAsValue(report, type);
    }
  }

  /**
   * Reads what callers need to know about findings of any bundle. Findings with something else,
   * which a bundle knows of its own, are not read: what a caller would miss could pass for a
   * result.
   */
  private static final class TraitReader extends JsonDeserializer<Rule.Trait> {

    @Override
    public Rule.Trait deserialize(JsonParser parser, DeserializationContext context)
        throws IOException {
      String name = parser.getText();
      for (CommonTrait each : CommonTrait.values()) {
        if (each.name().equals(name)) {
          return each;
        }
      }
      throw context.weirdStringException(name, Rule.Trait.class, "not known here");
    }
  }

  /** Requires each key that is not omitted in some cases, and refuses null for it. */
  private static final class RequiredUnlessOmitted extends JacksonAnnotationIntrospector {

    private static final long serialVersionUID = 1L;

    @Override
    public Boolean hasRequiredMarker(AnnotatedMember member) {
      return !mayBeOmitted(member);
    }

    @Override
    public JsonSetter.Value findSetterInfo(Annotated member) {
      return mayBeOmitted(member)
          ? super.findSetterInfo(member)
          : JsonSetter.Value.forValueNulls(Nulls.FAIL);
    }

    private static boolean mayBeOmitted(Annotated member) {
      return OptionalValues.TYPES.contains(member.getRawType())
          || member.hasAnnotation(JsonInclude.class);
    }
  }
}
