package dev.eventchain.sources;

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
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;

/**
 * Tests the length of files and methods. Exceptions are listed in {@code lengths.txt}, each with
 * its lines and the reason; they may become shorter, and leave the list when they are short.
 */
class LengthTest {

  private static final Path EXCEPTIONS = Path.of("src/test/resources/lengths.txt");
  private static final int LINES_OF_A_FILE = 400;
  private static final int LINES_OF_A_METHOD = 30;

  /** A line of the list: {@code NAME LINES REASON}. */
  private static final Pattern EXCEPTION = Pattern.compile("(\\S+) (\\d+) (\\S.*)");

  @Test
  void filesAreShort() throws IOException {
    List<Path> sources = new ArrayList<>(SourceFiles.ofBundles(".java"));
    sources.addAll(SourceFiles.ofBundles(".py"));
    SortedMap<String, Long> longer = new TreeMap<>();
    for (Path source : sources) {
      try (Stream<String> lines = Files.lines(source)) {
        long count = lines.count();
        if (count > LINES_OF_A_FILE) {
          longer.put(source.getFileName().toString(), count);
        }
      }
    }
    assertAsListed(longer, name -> !isMethod(name));
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
                  files.getJavaFileObjectsFromPaths(SourceFiles.ofBundles(".java")));
      SourcePositions positions = Trees.instance(task).getSourcePositions();
      for (CompilationUnitTree file : task.parse()) {
        new BodyLengths(file, positions, longer).scan(file, null);
      }
    }
    assertAsListed(longer, LengthTest::isMethod);
  }

  private static boolean isMethod(String name) {
    return !name.endsWith(".java") && !name.endsWith(".py");
  }

  /** An outdated entry would let a file grow again unnoticed. */
  private static void assertAsListed(SortedMap<String, Long> longer, Predicate<String> kind)
      throws IOException {
    SortedMap<String, Long> listed = new TreeMap<>();
    for (String line : Files.readAllLines(EXCEPTIONS)) {
      Matcher exception = EXCEPTION.matcher(line);
      if (!line.startsWith("#")) {
        assertTrue(exception.matches(), line);
        listed.put(exception.group(1), Long.valueOf(exception.group(2)));
      }
    }
    listed.keySet().removeIf(kind.negate());
    assertEquals(listed, longer, "longer than usual; see " + EXCEPTIONS);
  }

  /** Collects methods with too long bodies. */
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
