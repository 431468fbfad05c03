package dev.eventchain.simulation;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import dev.eventchain.simulation.verdict.Curve;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Writes {@code measurements.json}, with numbers rounded to their precision. */
final class MeasurementsWriter {

  private final JsonGenerator json;

  private MeasurementsWriter(JsonGenerator json) {
    this.json = json;
  }

  static byte[] write(SimulationResult result) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DefaultPrettyPrinter printer = new DefaultPrettyPrinter();
    printer.indentObjectsWith(new DefaultIndenter("  ", "\n"));
    try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
      json.setPrettyPrinter(printer);
      new MeasurementsWriter(json).result(result);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    bytes.write('\n');
    return bytes.toByteArray();
  }

  private void result(SimulationResult result) throws IOException {
    json.writeStartObject();
    json.writeStringField("runId", result.measurements().runId());
    json.writeBooleanField("passed", result.passed());
    json.writeArrayFieldStart("scenarios");
    for (ScenarioVerdict verdict : result.verdicts()) {
      scenario(verdict);
    }
    json.writeEndArray();
    json.writeArrayFieldStart("nodes");
    for (Measurements.Node node : result.measurements().nodes()) {
      node(node);
    }
    json.writeEndArray();
    flow(result.measurements().flow());
    host(result);
    json.writeEndObject();
  }

  private void scenario(ScenarioVerdict verdict) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", verdict.scenario());
    json.writeStringField("title", verdict.title());
    json.writeArrayFieldStart("requirements");
    for (String requirement : verdict.requirements()) {
      json.writeString(requirement);
    }
    json.writeEndArray();
    json.writeBooleanField("tested", verdict.tested());
    json.writeBooleanField("passed", verdict.passed());
    criteria("criteria", verdict.criteria());
    if (!verdict.observed().isEmpty()) {
      criteria("observed", verdict.observed());
    }
    figures(verdict.figures());
    statistics("latency", verdict.latency());
    json.writeArrayFieldStart("latencies");
    for (Optional<ScenarioVerdict.Latency> latency : verdict.latencies()) {
      latency(latency);
    }
    json.writeEndArray();
    flow(verdict.flow());
    series(verdict.series());
    json.writeEndObject();
  }

  private void criteria(String key, List<ScenarioVerdict.CriterionResult> criteria)
      throws IOException {
    json.writeArrayFieldStart(key);
    for (ScenarioVerdict.CriterionResult criterion : criteria) {
      json.writeStartObject();
      json.writeStringField("text", criterion.text());
      json.writeBooleanField("tested", criterion.tested());
      json.writeBooleanField("passed", criterion.passed());
      json.writeStringField("measured", criterion.measured());
      if (criterion.margin().isPresent()) {
        ScenarioVerdict.Margin margin = criterion.margin().get();
        json.writeObjectFieldStart("margin");
        field("value", margin.value());
        json.writeStringField("unit", margin.unit());
        field("time", margin.time());
        json.writeEndObject();
      }
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void figures(List<ScenarioVerdict.Figure> figures) throws IOException {
    json.writeArrayFieldStart("measurements");
    for (ScenarioVerdict.Figure figure : figures) {
      json.writeStartObject();
      json.writeStringField("name", figure.name());
      json.writeStringField("unit", figure.unit());
      json.writeStringField("statistic", figure.statistic().name());
      field("value", figure.value());
      field("time", figure.time());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void series(ScenarioVerdict.Series series) throws IOException {
    json.writeObjectFieldStart("series");
    column("time", series.time());
    json.writeArrayFieldStart("signals");
    for (Curve curve : series.curves()) {
      json.writeStartObject();
      json.writeStringField("name", curve.name());
      json.writeStringField("unit", curve.unit());
      column("values", curve.values());
      names(curve.names());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void names(List<Curve.Name> names) throws IOException {
    if (names.isEmpty()) {
      return;
    }
    json.writeArrayFieldStart("names");
    for (Curve.Name each : names) {
      json.writeStartObject();
      field("value", each.value());
      json.writeStringField("name", each.name());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void column(String name, List<Double> values) throws IOException {
    json.writeArrayFieldStart(name);
    for (double value : values) {
      number(value);
    }
    json.writeEndArray();
  }

  private void node(Measurements.Node node) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", node.name());
    json.writeNumberField("activations", node.activations());
    statistics("period", node.period());
    statistics("jitter", node.jitter());
    statistics("executionTime", node.executionTime());
    json.writeEndObject();
  }

  private void flow(MessageFlow flow) throws IOException {
    json.writeArrayFieldStart("hops");
    for (MessageFlow.Hop hop : flow.hops()) {
      hop(hop);
    }
    json.writeEndArray();
    json.writeArrayFieldStart("processing");
    for (MessageFlow.Processing node : flow.processing()) {
      json.writeStartObject();
      json.writeStringField("name", node.node());
      statistics("time", node.time());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeArrayFieldStart("topics");
    for (MessageFlow.Topic topic : flow.topics()) {
      json.writeStartObject();
      json.writeStringField("name", topic.name());
      count("published", topic.published());
      count("dropped", topic.dropped());
      count("lost", topic.lost());
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void hop(MessageFlow.Hop hop) throws IOException {
    json.writeStartObject();
    json.writeStringField("topic", hop.topic());
    json.writeStringField("writer", hop.writer());
    json.writeStringField("reader", hop.reader());
    statistics("waiting", hop.waiting());
    statistics("age", hop.age());
    json.writeFieldName("samples");
    if (hop.samples().isPresent()) {
      MessageFlow.Samples samples = hop.samples().get();
      json.writeStartObject();
      json.writeNumberField("published", samples.published());
      json.writeNumberField("read", samples.read());
      json.writeNumberField("neverRead", samples.neverRead());
      json.writeNumberField("unreadAtEnd", samples.unreadAtEnd());
      json.writeEndObject();
    } else {
      json.writeNull();
    }
    exceeded("tooOld", hop.tooOld());
    exceeded("late", hop.late());
    json.writeEndObject();
  }

  private void exceeded(String name, Optional<MessageFlow.Exceeded> exceeded) throws IOException {
    json.writeFieldName(name);
    if (exceeded.isEmpty()) {
      json.writeNull();
      return;
    }
    json.writeStartObject();
    field("limit", exceeded.get().limit());
    json.writeNumberField("times", exceeded.get().times());
    json.writeNumberField("of", exceeded.get().of());
    json.writeEndObject();
  }

  private void count(String name, OptionalLong count) throws IOException {
    json.writeFieldName(name);
    if (count.isPresent()) {
      json.writeNumber(count.getAsLong());
    } else {
      json.writeNull();
    }
  }

  /** Writes the values that differ from run to run, apart from the others. */
  private void host(SimulationResult result) throws IOException {
    SimulationResult.Host host = result.host();
    json.writeObjectFieldStart("host");
    json.writeStringField("driver", host.driver());
    json.writeStringField("confinement", host.confinement());
    json.writeStringField("python", host.python());
    json.writeNumberField("processes", host.processes());
    field("simulatedSeconds", host.simulatedSeconds());
    field("wallSeconds", host.wallSeconds());
    field("realTimeFactor", host.realTimeFactor());
    json.writeArrayFieldStart("nodes");
    for (Measurements.Node node : result.measurements().nodes()) {
      json.writeStartObject();
      json.writeStringField("name", node.name());
      statistics("hostExecutionTime", node.hostExecutionTime());
      optional("timesWorstCase", node.timesWorstCase());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void statistics(String name, Optional<Measurements.Statistics> values)
      throws IOException {
    json.writeFieldName(name);
    if (values.isEmpty()) {
      json.writeNull();
      return;
    }
    json.writeStartObject();
    statistics(values.get());
    json.writeEndObject();
  }

  private void statistics(Measurements.Statistics values) throws IOException {
    field("minimum", values.minimum());
    field("mean", values.mean());
    field("median", values.median());
    field("percentile99", values.percentile99());
    field("maximum", values.maximum());
    json.writeNumberField("count", values.count());
  }

  /**
   * Writes a latency; the parts of the slowest time add up to the maximum. The part of it that is
   * not in the messages is written as {@code values}.
   */
  private void latency(Optional<ScenarioVerdict.Latency> latency) throws IOException {
    if (latency.isEmpty()) {
      json.writeNull();
      return;
    }
    json.writeStartObject();
    statistics(latency.get().statistics());
    field("values", latency.get().values());
    json.writeArrayFieldStart("slowest");
    for (ScenarioVerdict.Part part : latency.get().slowest()) {
      json.writeStartObject();
      json.writeStringField("node", part.node());
      field("waiting", part.waiting());
      field("execution", part.execution());
      json.writeEndObject();
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void optional(String name, OptionalDouble value) throws IOException {
    field(name, value.orElse(Double.NaN));
  }

  private void field(String name, double value) throws IOException {
    json.writeFieldName(name);
    number(value);
  }

  /** Writes a number with four decimals; NaN and infinity become null. */
  private void number(double value) throws IOException {
    if (Double.isFinite(value)) {
      json.writeNumber(rounded(value));
    } else {
      json.writeNull();
    }
  }

  static double rounded(double value) {
    return Math.rint(value * 1e4) / 1e4;
  }
}
