package dev.eventchain.pipeline.measure;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.simulate.MeasuredTimes;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.simulation.tracing.RecordedTrace;
import dev.eventchain.simulation.tracing.TraceMeasurement;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Times of a project's chain in a recorded trace of ROS 2, compared with the numbers of its model.
 *
 * @param text the measured times, for people
 * @param files what was written, and the findings
 */
public record TraceMeasuring(String text, WrittenFiles files) {

  /** The folder of the results, in the output folder. */
  public static final String FOLDER = "traced";

  private static final List<String> BABELTRACE = List.of("babeltrace2");

  /**
   * Measures.
   *
   * @param model the chain's model, of the project or among its results
   * @param output where the results of the project are, and the folder of these
   * @param trace a folder of LTTng, or the text of babeltrace2
   * @param timeLimit the processor time that the patterns of a data type may take
   * @param suppressions which findings are accepted
   * @param onEdit what becomes of files that a person has edited
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read or is no
   *     trace, UNAVAILABLE if it takes a program that is not there; earlier results are gone then
   */
  public static TraceMeasuring of(
      Project project,
      Path model,
      Path output,
      Path trace,
      Duration timeLimit,
      Suppressions suppressions,
      OnEdit onEdit) {
    WrittenFiles written = new WrittenFiles(Optional.of(output.resolve(FOLDER)));
    try (OutputFolder folder = OutputFolder.open(output)) {
      folder.damage().ifPresent(it -> written.found(List.of(it)));
      for (String name :
          List.of(SimulateStage.MEASURED_MODEL, SimulateStage.MEASUREMENTS, MeasuredTimes.DIFF)) {
        folder.removeAll(FOLDER + "/" + name);
      }
      ChainModel chain = ChainModel.read(project, output, model, timeLimit);
      RecordedTrace read = Babeltrace.read(trace, BABELTRACE);
      TraceMeasurement measured = TraceMeasurement.of(chain.chain(), read);
      SourceLocation place = SourceLocation.of(trace);
      List<Diagnostic> found = TraceFindings.of(chain, place, read, measured);
      written.found(found);
      boolean passed = !Diagnostic.anyError(suppressions.part(found).remaining());
      Map<String, byte[]> files = new TreeMap<>(diff(project, measured));
      if (!measured.components().isEmpty()) {
        EventChain copy = measured.measuredModel(chain.chain(), name(trace), passed);
        files.put(FOLDER + "/" + SimulateStage.MEASURED_MODEL, XmiStore.toBytes(copy));
        TraceJson json = TraceJson.of(chain.chain(), read, measured);
        files.put(FOLDER + "/" + SimulateStage.MEASUREMENTS, ResultJson.indented(json));
      }
      written.write(folder, files, onEdit);
      return new TraceMeasuring(TraceTable.of(chain.chain(), measured), written);
    }
  }

  private static String name(Path trace) {
    return trace.toAbsolutePath().normalize().getFileName().toString();
  }

  /** Returns the change that states the measured execution times, if there is one. */
  private static Map<String, byte[]> diff(Project project, TraceMeasurement measured) {
    Map<String, Double> longest = new LinkedHashMap<>();
    for (TraceMeasurement.Component each : measured.components()) {
      each.times()
          .executionTime()
          .ifPresent(time -> longest.put(each.times().name(), time.maximum()));
    }
    return MeasuredTimes.of(project, longest)
        .flatMap(MeasuredTimes::diff)
        .map(it -> Map.of(FOLDER + "/" + MeasuredTimes.DIFF, it.getBytes(StandardCharsets.UTF_8)))
        .orElse(Map.of());
  }
}
