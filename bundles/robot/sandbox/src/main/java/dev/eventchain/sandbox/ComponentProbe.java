package dev.eventchain.sandbox;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Checks that a Python file is a component: a class whose {@code execute} takes the inputs by name
 * and returns a dict with exactly the outputs. The file is first checked statically. Only without
 * findings is it imported and called, in a {@link ConfinedProcess} separate from the checking one.
 *
 * <p>Findings, each an error with the place in the file: {@code component.syntax}, {@code
 * component.class.missing}, {@code component.constructor.signature}, {@code
 * component.execute.signature}, {@code component.import.forbidden}, {@code
 * component.import.effect}, {@code component.call.forbidden}; and from execution {@code
 * component.raised}, {@code component.timeout}, {@code component.ended}, {@code
 * component.result.type}, {@code component.result.keys}, {@code component.result.nan}, {@code
 * component.state.shared}.
 */
public final class ComponentProbe {

  private static final ObjectMapper JSON =
      JsonMapper.builder().disable(JsonWriteFeature.WRITE_NAN_AS_STRINGS).build();
  private static final Duration WALL_TIME = Duration.ofSeconds(60);
  private static final Duration LONGEST = Duration.ofMinutes(10);
  private static final int MEMORY_MIB = 512;
  private static final int MAXIMAL_OUTPUT = 16 << 20;

  private final PythonEnvironment environment;
  private final Duration timeLimit;
  private final Duration wallTime;
  private final Confinement confinement;
  private final boolean existing;

  /**
   * Creates a probe for this Python. Import and each call may take two seconds of processor time,
   * and one minute of wall time, since waiting uses no processor time.
   */
  public ComponentProbe(PythonEnvironment environment) {
    this(environment, Duration.ofSeconds(2), WALL_TIME, Confinement.detect(), false);
  }

  ComponentProbe(
      PythonEnvironment environment,
      Duration timeLimit,
      Duration wallTime,
      Confinement confinement) {
    this(environment, timeLimit, wallTime, confinement, false);
  }

  private ComponentProbe(
      PythonEnvironment environment,
      Duration timeLimit,
      Duration wallTime,
      Confinement confinement,
      boolean existing) {
    this.environment = environment;
    this.timeLimit = timeLimit;
    this.wallTime = wallTime;
    this.confinement = confinement;
    this.existing = existing;
  }

  /**
   * Returns a copy for hand-written components: they may import and call what generated ones must
   * not, and import modules next to them.
   */
  public ComponentProbe ofExisting() {
    return new ComponentProbe(environment, timeLimit, wallTime, confinement, true);
  }

  /**
   * Checks a file.
   *
   * @param calls calls made in sequence on one component instance, so that state has an effect
   * @return the findings, sorted by place in the file; empty if there are none
   * @throws dev.eventchain.diagnostics.DiagnosticException the file is missing or not UTF-8 text,
   *     or Python is unavailable
   */
  public List<Diagnostic> check(
      Path file, ComponentSignature signature, List<ComponentCall> calls) {
    return run(file, signature, calls, List.of()).diagnostics(SourceText.read(file));
  }

  /**
   * Makes sequences of calls, each on a new component instance of the file.
   *
   * @return the results of the sequences, in order; a single result with a problem if the static
   *     check has findings, or if not all calls were made
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link #check} does
   */
  public List<CallResults> call(
      Path file, ComponentSignature signature, List<List<ComponentCall>> sequences) {
    return run(file, signature, List.of(), sequences)
        .results(SourceText.read(file), sequences.size());
  }

  private ProbeReport run(
      Path file,
      ComponentSignature signature,
      List<ComponentCall> calls,
      List<List<ComponentCall>> sequences) {
    Path absolute = file.toAbsolutePath().normalize();
    SourceText.read(absolute); // reports a file that cannot be read
    int count = calls.size() + sequences.stream().mapToInt(each -> each.size() + 1).sum();
    try (WorkFolder folder = WorkFolder.create()) {
      return run(absolute, request(absolute, signature, calls, sequences), count, folder.path());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private ProbeReport run(Path file, byte[] request, int calls, Path workFolder)
      throws IOException {
    Path sources = PythonSources.unpack(getClass().getClassLoader(), "dev/eventchain/sandbox");
    Duration processorTime = timeLimit.multipliedBy(2L * calls + 3).plusSeconds(2);
    try (ConfinedProcess process =
        ConfinedProcess.on(environment)
            .script(sources.resolve("component_probe.py"))
            .components(0, file)
            .readable(existing ? file.getParent() : file)
            .workFolder(workFolder)
            .limits(new ConfinedProcess.Limits(LONGEST, processorTime, MEMORY_MIB))
            .confinement(confinement)
            .start()) {
      ConfinedProcess.Answer answer = process.ask(request, MAXIMAL_OUTPUT);
      return new ProbeReport(answer.output(), answer.end(), answer.standardError());
    }
  }

  private byte[] request(
      Path file,
      ComponentSignature signature,
      List<ComponentCall> calls,
      List<List<ComponentCall>> sequences)
      throws IOException {
    ObjectNode request = JSON.createObjectNode();
    request.put("file", file.toString());
    request.put("class", signature.className());
    request.put("existing", existing);
    request.set("inputs", JSON.valueToTree(signature.inputs()));
    request.set("outputs", JSON.valueToTree(signature.outputs()));
    request.set("types", JSON.valueToTree(signature.outputTypes()));
    request.put("processorSeconds", timeLimit.toMillis() / 1000.0);
    request.put("wallSeconds", wallTime.toMillis() / 1000.0);
    addCalls(request.putArray("calls"), calls);
    ArrayNode lists = request.putArray("sequences");
    sequences.forEach(sequence -> addCalls(lists.addArray(), sequence));
    return JSON.writer()
        .without(JsonGenerator.Feature.AUTO_CLOSE_TARGET)
        .writeValueAsBytes(request);
  }

  private static void addCalls(ArrayNode list, List<ComponentCall> calls) {
    for (ComponentCall call : calls) {
      ObjectNode entry = list.addObject().put("name", call.name());
      ObjectNode arguments = entry.putObject("arguments");
      call.arguments()
          .forEach((name, value) -> arguments.set(name, JSON.valueToTree(encode(value))));
    }
  }

  /** Encodes arrays and messages for {@code decode} of component_probe.py. */
  private static Object encode(Object value) {
    if (value instanceof byte[] bytes) {
      return Map.of("$bytes", Base64.getEncoder().encodeToString(bytes));
    }
    if (value instanceof float[]) {
      return Map.of("$array", "f", "values", value);
    }
    if (value instanceof double[]) {
      return Map.of("$array", "d", "values", value);
    }
    if (value instanceof ComponentCall.Message message) {
      Map<String, Object> fields = new LinkedHashMap<>();
      message.fields().forEach((name, field) -> fields.put(name, encode(field)));
      return Map.of("$message", message.type(), "fields", fields);
    }
    if (value instanceof List<?> list) {
      return list.stream().map(ComponentProbe::encode).toList();
    }
    return value instanceof int[] ? Map.of("$array", "i", "values", value) : value;
  }
}
