package dev.eventchain.pipeline.generate;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/** Lines of the generated files by the component that they were generated for, from trace.json. */
public final class GeneratedLines {

  /** The lines of a file that were generated for a component. */
  public record Made(String node, String file, List<Lines> lines) {}

  /**
   * A range of lines.
   *
   * @param from the template and its line
   */
  public record Lines(int first, int last, String from) {}

  private final List<TraceFile.Lined> files;

  private GeneratedLines(List<TraceFile.Lined> files) {
    this.files = files;
  }

  /** Reads the trace; empty if it is missing or unreadable. */
  public static GeneratedLines of(RunContext run) {
    Optional<byte[]> trace = run.output().read(TraceFile.NAME);
    try {
      return new GeneratedLines(
          trace.isPresent() ? TraceFile.read(trace.get()).files() : List.of());
    } catch (IOException e) {
      return new GeneratedLines(List.of());
    }
  }

  /**
   * Returns the files with lines generated for a component or its data.
   *
   * @param locator returns the locations of elements, as in the generation
   */
  public List<Made> madeFor(SoftwareNode node, Function<EObject, SourceLocation> locator) {
    Set<String> elements = new TreeSet<>();
    Stream.of(Stream.of(node), node.getInput().stream(), node.getOutput().stream())
        .flatMap(each -> each)
        .map(locator)
        .forEach(place -> elements.add(key(place.element(), place.line())));
    return files.stream()
        .map(file -> new Made(node.getName(), file.file(), linesOf(file, elements)))
        .filter(made -> !made.lines().isEmpty())
        .toList();
  }

  private static List<Lines> linesOf(TraceFile.Lined file, Set<String> elements) {
    List<Lines> lines = new ArrayList<>();
    for (TraceFile.Range range : file.lines()) {
      range.from().stream()
          .filter(from -> elements.contains(key(from.element().orElse(""), line(from))))
          .map(from -> new Lines(range.first(), range.last(), from.template() + ":" + from.line()))
          .findFirst()
          .ifPresent(lines::add);
    }
    return lines;
  }

  private static int line(TraceFile.From from) {
    return (int) from.modelLine().orElse(0);
  }

  /**
   * Returns the key of an element by name and line. Elements with the same name on the same line,
   * as in handwritten one-line models, share their lines.
   */
  private static String key(String element, int line) {
    return line + " " + element;
  }
}
