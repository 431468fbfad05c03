package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.LineMap;
import com.sun.source.tree.MethodTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * Files and methods are short. A method that is longer is named with the lines that it may have,
 * which may be lowered; one that is not too long any more must not be named.
 */
class LengthTest {

  private static final Path BUNDLES = Path.of("..", "..", "bundles");
  private static final int LINES_OF_A_FILE = 400;
  private static final int LINES_OF_A_METHOD = 30;

  /** Methods by class, with the lines of their bodies. */
  private static final Map<String, Long> LONG_METHODS =
      Map.ofEntries(
          Map.entry("BodyCompiler.forStep", 33L),
          Map.entry("CdrReader.numbers", 32L),
          Map.entry("CollectionOperations.addOrder", 47L),
          Map.entry("DeepStack.all", 32L),
          Map.entry("Expression.evaluate", 32L),
          Map.entry("ModelComparison.compareContents", 31L),
          Map.entry("OclAnalyzer.ERROR", 35L),
          Map.entry("QosContracts.compare", 39L),
          Map.entry("ReportPage.render", 38L),
          Map.entry("ResultBuilder.measure", 31L),
          Map.entry("TextOperations.addSubstitutions", 31L),
          Map.entry("UnitContracts.compare", 52L));

  @Test
  void filesAreShort() throws IOException {
    List<Path> sources = sources(".java");
    sources.addAll(sources(".py"));
    SortedMap<String, Long> longer = new TreeMap<>();
    for (Path source : sources) {
      try (Stream<String> lines = Files.lines(source)) {
        long count = lines.count();
        if (count > LINES_OF_A_FILE) {
          longer.put(source.getFileName().toString(), count);
        }
      }
    }
    assertEquals(Map.of(), longer);
  }

  @Test
  void methodsAreShort() throws IOException {
    SortedMap<String, Long> longer = new TreeMap<>();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null,
                  files,
                  null,
                  null,
                  null,
                  files.getJavaFileObjectsFromPaths(sources(".java")));
      SourcePositions positions = Trees.instance(task).getSourcePositions();
      for (CompilationUnitTree file : task.parse()) {
        new BodyLengths(file, positions, longer).scan(file, null);
      }
    }
    SortedMap<String, Long> allowed = new TreeMap<>(LONG_METHODS);
    longer.forEach(
        (method, lines) -> allowed.computeIfPresent(method, (name, most) -> Math.min(most, lines)));
    assertEquals(allowed, longer, "methods of more than " + LINES_OF_A_METHOD + " lines");
  }

  /** The hand-written code that ships. */
  private static List<Path> sources(String suffix) throws IOException {
    try (Stream<Path> files = Files.walk(BUNDLES)) {
      List<Path> found =
          new ArrayList<>(
              files
                  .filter(file -> file.toString().endsWith(suffix))
                  .filter(file -> isMain(BUNDLES.relativize(file)))
                  .sorted()
                  .toList());
      assertTrue(found.size() > 20, "only " + found);
      return found;
    }
  }

  private static boolean isMain(Path file) {
    String path = file.toString().replace('\\', '/');
    return path.matches("(eclipse/)?[^/]+/(src/main|python)/.*");
  }

  /** Collects the methods whose bodies are too long. */
  private static final class BodyLengths extends TreeScanner<Void, Void> {
    private final CompilationUnitTree file;
    private final SourcePositions positions;
    private final Map<String, Long> longer;

    BodyLengths(CompilationUnitTree file, SourcePositions positions, Map<String, Long> longer) {
      this.file = file;
      this.positions = positions;
      this.longer = longer;
    }

    @Override
    public Void visitMethod(MethodTree method, Void none) {
      if (method.getBody() != null) {
        LineMap lines = file.getLineMap();
        long first = lines.getLineNumber(positions.getStartPosition(file, method.getBody()));
        long last = lines.getLineNumber(positions.getEndPosition(file, method.getBody()));
        if (last - first + 1 > LINES_OF_A_METHOD) {
          String type = Path.of(file.getSourceFile().toUri()).getFileName().toString();
          longer.merge(type.replace(".java", ".") + method.getName(), last - first + 1, Math::max);
        }
      }
      return super.visitMethod(method, null);
    }
  }
}
