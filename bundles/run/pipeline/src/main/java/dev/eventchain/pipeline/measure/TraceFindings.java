package dev.eventchain.pipeline.measure;

import dev.eventchain.check.ChainModel;
import dev.eventchain.contracts.latency.ChainTiming;
import dev.eventchain.contracts.latency.LatencyEstimate;
import dev.eventchain.contracts.latency.Stimuli;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.tracing.RecordedTrace;
import dev.eventchain.simulation.tracing.TraceMeasurement;
import dev.eventchain.simulation.verdict.Measurements.Statistics;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Latency;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;

/** Findings about a trace, and about a chain whose numbers it refutes. */
final class TraceFindings {

  private static final double MILLISECOND = 1e6;
  private static final double SECOND = 1e3;

  /** The part of a period from which on its median is another one, and no jitter. */
  private static final double LONGER = 1.05;

  private final ChainModel model;
  private final SourceLocation trace;
  private final TraceMeasurement measured;
  private final List<Diagnostic> found = new ArrayList<>();

  private TraceFindings(ChainModel model, SourceLocation trace, TraceMeasurement measured) {
    this.model = model;
    this.trace = trace;
    this.measured = measured;
  }

  /**
   * Returns the findings.
   *
   * @param place the trace
   */
  static List<Diagnostic> of(
      ChainModel model, SourceLocation place, RecordedTrace trace, TraceMeasurement measured) {
    TraceFindings findings = new TraceFindings(model, place, measured);
    findings.lost(trace);
    findings.mixed(trace);
    if (measured.components().isEmpty()) {
      findings.nothing(trace);
      return findings.found;
    }
    findings.missing(trace);
    findings.idle();
    findings.unmatched();
    findings.earlier();
    findings.outside();
    model.chain().getSoftware().forEach(findings::times);
    findings.latencies();
    return findings.found;
  }

  private void lost(RecordedTrace read) {
    if (!read.lost().isEmpty()) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_LOST,
                  "Events of the trace were lost (%s), so that each time is a lower bound and no constraint is shown to hold."
                      .formatted(String.join(", ", read.lost())),
                  trace)
              .withHint(
                  "Record again with more or larger buffers (lttng enable-channel --subbuf-size, --num-subbuf), or fewer events."));
    }
  }

  private void mixed(RecordedTrace read) {
    if (!read.mixed().isEmpty() && read.lost().isEmpty()) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_THREAD_MIXED,
                  "Callbacks of one thread overlap (%s), so that several processes have the same ids and their times are mixed."
                      .formatted(String.join("; ", read.mixed())),
                  trace)
              .withHint(
                  "Record the namespaces of ids, too: lttng add-context --userspace --type=pid_ns"));
    }
  }

  private void nothing(RecordedTrace read) {
    List<String> names = read.nodes();
    String known =
        names.isEmpty()
            ? "it has no node at all (ros2:rcl_node_init)"
            : "its nodes are " + Printable.line(String.join(", ", names));
    found.add(
        Diagnostic.of(
                MeasureRules.TRACE_UNMATCHED,
                "The trace has no component of the chain: %s.".formatted(known),
                trace)
            .withHint(
                "Start the trace before the nodes; each has to be called like its component, as the generated ones are."));
  }

  private void missing(RecordedTrace read) {
    String others = others(read);
    for (SoftwareNode node : model.chain().getSoftware()) {
      String reason = measured.missing().get(node.getName());
      if (reason != null) {
        found.add(
            Diagnostic.of(
                    MeasureRules.TRACE_NODE_MISSING,
                    "'%s' is not in the trace: %s.".formatted(node.getName(), reason),
                    model.locate(node))
                .withHint(
                    "Trace the machine and the process in which it runs, from its start."
                        + others));
      }
    }
    for (TraceMeasurement.Component each : measured.components()) {
      if (each.times().activations() == 0) {
        found.add(
            Diagnostic.of(
                    MeasureRules.TRACE_NODE_MISSING,
                    "'%s' did nothing in the trace: no callback was executed, and nothing published."
                        .formatted(each.times().name()),
                    trace)
                .withHint(
                    "Trace rcl, rclcpp and rmw while the node works, and give its topics the names of the model."));
      }
    }
  }

  /** Returns what to say of the nodes that are no component, one of which may have another name. */
  private String others(RecordedTrace read) {
    List<String> nodes = new ArrayList<>(read.nodes());
    measured.components().forEach(each -> nodes.remove(each.node()));
    return nodes.isEmpty()
        ? ""
        : " The trace also has %s: if that is the component, start it under its name (--ros-args -r __node:=NAME)."
            .formatted(Printable.line(String.join(", ", nodes)));
  }

  /** Reports that no component did anything: without constraints, nothing else is an error then. */
  private void idle() {
    if (measured.components().stream().allMatch(each -> each.times().activations() == 0)) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_UNMATCHED,
                  "No component of the chain did anything in the trace, so that nothing was measured.",
                  trace)
              .withHint("Trace the nodes while data pass through the chain."));
    }
  }

  private void unmatched() {
    for (TraceMeasurement.Unmatched each : measured.unmatched()) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_MESSAGE_UNMATCHED,
                  String.format(
                      Locale.ROOT,
                      "%d times, it is not known which message of %s '%s' read.",
                      each.count(),
                      each.topic(),
                      each.reader()),
                  trace)
              .withHint(
                  "Trace all publishers of the topic, without intra-process communication, and with one thread for each node in Python."));
    }
  }

  private void earlier() {
    for (TraceMeasurement.Unmatched each : measured.earlier()) {
      found.add(
          Diagnostic.of(
              MeasureRules.TRACE_MESSAGE_EARLIER,
              String.format(
                  Locale.ROOT,
                  "Messages of %s that '%s' read were published before the trace began, and are left out: %d.",
                  each.topic(),
                  each.reader(),
                  each.count()),
              trace));
    }
  }

  private void outside() {
    for (Map.Entry<String, Integer> each : measured.outside().entrySet()) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_PUBLISHER_MISSING,
                  String.format(
                      Locale.ROOT,
                      "The publisher of %s is not in the trace: its %d messages count as published at the time that they carry, by the clock of another process or machine.",
                      each.getKey(),
                      each.getValue()),
                  trace)
              .withHint(
                  "Trace the publisher, too; or suppress this finding where its clock is that of this machine, or synchronized."));
    }
  }

  /** Compares a component with the worst case and the frequency of the model. */
  private void times(SoftwareNode node) {
    for (TraceMeasurement.Component each : measured.components()) {
      if (each.times().name().equals(node.getName())) {
        each.times()
            .executionTime()
            .filter(it -> node.isSetWorstCaseExecutionTime())
            .filter(it -> it.maximum() > node.getWorstCaseExecutionTime())
            .ifPresent(it -> slow(node, it.maximum()));
        each.times()
            .period()
            .filter(it -> node.getFrequency() > 0)
            .filter(it -> it.median() > LONGER * SECOND / node.getFrequency())
            .ifPresent(it -> seldom(node, it.median()));
      }
    }
  }

  private void slow(SoftwareNode node, double longest) {
    found.add(
        Diagnostic.of(
                MeasureRules.TRACE_TIME_ABOVE,
                "'%s' took up to %s ms in the trace, longer than its worst case of %s ms."
                    .formatted(node.getName(), ms(longest), ms(node.getWorstCaseExecutionTime())),
                model.locate(node, Literals.SOFTWARE_NODE__WORST_CASE_EXECUTION_TIME))
            .withHint(
                "The time from the start to the end of a callback has in it what interrupted it. State a worst case that holds, or give the node a processor of its own."));
  }

  private void seldom(SoftwareNode node, double median) {
    found.add(
        Diagnostic.of(
                MeasureRules.TRACE_PERIOD_ABOVE,
                "'%s' was executed every %s ms (median) in the trace, but the model says every %s ms."
                    .formatted(node.getName(), ms(median), ms(SECOND / node.getFrequency())),
                model.locate(node, Literals.SOFTWARE_NODE__FREQUENCY))
            .withHint(
                "Bounds on latencies count the period of the model: state the frequency that the node has."));
  }

  private void latencies() {
    EventChain chain = model.chain();
    ChainTiming timing = ChainTiming.of(chain, new TracedStimuli(measured));
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      Optional<Latency> latency = measured.latencies().get(i);
      if (latency.isEmpty()) {
        unmeasured(constraint);
      } else {
        exceeded(constraint, latency.get());
        unanswered(constraint, measured.unanswered().get(i));
        aboveBound(constraint, latency.get(), timing.of(constraint));
      }
    }
  }

  private void unmeasured(LatencyConstraint constraint) {
    found.add(
        Diagnostic.of(
                MeasureRules.TRACE_LATENCY_UNMEASURED,
                "The latency constraint '%s' was not measured: in the trace, no output of '%s' is based on an input of '%s'."
                    .formatted(
                        constraint.getName(),
                        name(constraint.getLast()),
                        name(constraint.getFirst())),
                model.locate(constraint))
            .withHint(
                "Trace all components between them, while data pass from the first one to the last one."));
  }

  private static String name(SoftwareNode node) {
    return node == null ? "?" : node.getName();
  }

  private void exceeded(LatencyConstraint constraint, Latency latency) {
    double maximum = constraint.getMaximum();
    if (maximum > 0 && latency.statistics().maximum() > maximum) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_LATENCY_EXCEEDED,
                  "'%s' allows %s ms, but took up to %s ms in the trace (waiting + execution: %s)."
                      .formatted(
                          constraint.getName(),
                          ms(maximum),
                          ms(latency.statistics().maximum()),
                          TraceTable.parts(latency)),
                  model.locate(constraint, Literals.LATENCY_CONSTRAINT__MAXIMUM))
              .withHint("Execute components on the way more often or faster, or allow more time."));
    }
  }

  private void unanswered(LatencyConstraint constraint, TraceMeasurement.Unanswered unanswered) {
    double maximum = constraint.getMaximum();
    if (maximum <= 0 || unanswered.longest() <= maximum + inForce(constraint)) {
      return;
    }
    String until =
        unanswered.untilEnd() > unanswered.untilLater()
            ? "to the end of the trace, %s ms, no output of '%s' was based on new messages"
            : "it took up to %s ms until an output of '%s' was based on new messages";
    found.add(
        Diagnostic.of(
                MeasureRules.TRACE_LATENCY_UNANSWERED,
                String.format(
                    Locale.ROOT,
                    "'%s' allows %s ms, but %s; never answered: %d.",
                    constraint.getName(),
                    ms(maximum),
                    until.formatted(ms(unanswered.longest()), name(constraint.getLast())),
                    unanswered.count()),
                model.locate(constraint, Literals.LATENCY_CONSTRAINT__MAXIMUM))
            .withHint(
                "A component on the way has stopped, hangs, or reads messages too seldom. Nodes that are ended before the trace look as if they hung: stop the trace first. Suppress this where one publishes only on events."));
  }

  /** Returns for how long an output stands whose age was allowed when it was written, in ms. */
  private double inForce(LatencyConstraint constraint) {
    if (constraint.getKind() != LatencyKind.DATA_AGE) {
      return 0;
    }
    SoftwareNode last = constraint.getLast();
    return last.getFrequency() > 0
        ? SECOND / last.getFrequency()
        : measured.components().stream()
            .filter(it -> it.times().name().equals(last.getName()))
            .flatMap(it -> it.times().period().stream())
            .mapToDouble(Statistics::median)
            .findFirst()
            .orElse(0);
  }

  private void aboveBound(LatencyConstraint constraint, Latency latency, LatencyEstimate estimate) {
    OptionalLong bound = estimate.bound();
    if (bound.isPresent() && latency.statistics().maximum() * MILLISECOND > bound.getAsLong()) {
      found.add(
          Diagnostic.of(
                  MeasureRules.TRACE_LATENCY_ABOVE_BOUND,
                  "'%s' took up to %s ms in the trace, but by the numbers of the model %s ms are the most (waiting + execution: %s)."
                      .formatted(
                          constraint.getName(),
                          ms(latency.statistics().maximum()),
                          LatencyEstimate.milliseconds(bound.getAsLong()),
                          estimate.shares()),
                  model.locate(constraint))
              .withHint(
                  "A worst case, a frequency or a transport time of the model does not hold: compare the tables of the trace with them."));
    }
  }

  private static String ms(double milliseconds) {
    return LatencyEstimate.milliseconds((long) Math.ceil(milliseconds * MILLISECOND));
  }

  /** Messages from outside of the chain, as far apart as they were in a trace. */
  private record TracedStimuli(TraceMeasurement measured) implements Stimuli {

    @Override
    public OptionalLong interval(String topic) {
      Long longest = measured.intervals().get(topic);
      return longest == null ? OptionalLong.empty() : OptionalLong.of(longest);
    }

    @Override
    public long before(String topic, LatencyConstraint constraint) {
      return 0;
    }
  }
}
