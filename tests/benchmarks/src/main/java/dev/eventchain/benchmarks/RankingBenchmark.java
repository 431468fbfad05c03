package dev.eventchain.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Prints how much a search finds of what is wrong with three releases of one component of the radar
 * example: the first brakes too little at some speeds, the second repairs that and waits too long
 * where a vehicle is seen late, the third is the example's. A grid knows all failures. The points
 * of a protocol are beside it, and random draws.
 */
public final class RankingBenchmark {

  private static final int RUNS = 100;
  private static final int SEEDS = 3;
  private static final List<String> METHODS = List.of("random", "cma_es");
  private static final String COMPONENT = "software-base/components/Brake_Request.py";

  /** Columns of a table before the verdict: the number, four factors, the repetition. */
  private static final int VERDICT = 6;

  private final Path root;
  private final Path folder;

  private RankingBenchmark(Path root, Path folder) {
    this.root = root;
    this.folder = folder;
  }

  /**
   * Prints the figures.
   *
   * @param arguments the project's root folder
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("eventchain-benchmark");
    try {
      RankingBenchmark benchmark = new RankingBenchmark(Path.of(arguments[0]), folder);
      for (int release = 1; release <= 3; release++) {
        benchmark.run(release);
      }
    } finally {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  private void run(int release) throws IOException, InterruptedException {
    Path project = folder.resolve("release-" + release);
    copy(root.resolve("examples/radar-aeb"), project);
    Files.writeString(project.resolve("scenarios/approach.yaml"), resource("approach.yaml"));
    if (release < 3) {
      Files.writeString(project.resolve(COMPONENT), resource("release-" + release + ".py"));
      Files.delete(project.resolve("tests/Brake_Request.yaml")); // It would find these defects.
    }
    List<String> grid = rows(project, "campaign", resource("grid.yaml"));
    Set<String> all = failed(grid);
    Set<String> points = failed(rows(project, "campaign", resource("points.yaml")));
    System.out.printf(
        Locale.ROOT,
        "release %d: %d of %d cases of the grid fail, %d points of the protocol%n",
        release,
        all.size(),
        grid.size(),
        points.size());
    for (String method : METHODS) {
      for (int seed = 1; seed <= SEEDS; seed++) {
        String search = "seed: %d%nsearch: {runs: %d, method: %s}%n".formatted(seed, RUNS, method);
        print(method, seed, rows(project, "search", resource("grid.yaml") + search), all);
      }
    }
  }

  private static void print(String method, int seed, List<String> rows, Set<String> all) {
    Set<String> found = failed(rows);
    int first =
        IntStream.range(0, rows.size()).filter(i -> isFailed(rows.get(i))).findFirst().orElse(-1);
    System.out.printf(
        Locale.ROOT,
        "  %-6s seed %d: first failure in run %s, %3d different ones in %d runs, %d %% of all%s%n",
        method,
        seed,
        first < 0 ? "-" : Integer.toString(first + 1),
        found.size(),
        rows.size(),
        all.isEmpty() ? 0 : 100 * found.size() / all.size(),
        all.containsAll(found) ? "" : ", of which the grid does not know some");
  }

  /** Returns the values of the cases that failed. */
  private static Set<String> failed(List<String> rows) {
    return rows.stream()
        .filter(RankingBenchmark::isFailed)
        .map(row -> row.split(",", VERDICT + 1))
        .map(cells -> String.join(",", List.of(cells).subList(1, VERDICT - 1)))
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  private static boolean isFailed(String row) {
    return row.split(",", VERDICT + 2)[VERDICT].equals("failed");
  }

  /** Returns the rows of the table of a command's results. */
  private List<String> rows(Path project, String command, String text)
      throws IOException, InterruptedException {
    Path file = Files.writeString(folder.resolve("ranking.yaml"), text);
    int code =
        new ProcessBuilder("./eventchain", command, project.toString(), file.toString())
            .directory(root.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start()
            .waitFor();
    if (code > 1) { // 1: something failed
      throw new IllegalStateException(command + " ended with " + code);
    }
    String results = command.equals("search") ? "out/searches" : "out/campaigns";
    List<String> lines = Files.readAllLines(project.resolve(results + "/ranking/cases.csv"));
    return lines.subList(1, lines.size());
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path name = from.relativize(file);
        if (!name.startsWith("out")) {
          Files.copy(file, to.resolve(name), StandardCopyOption.COPY_ATTRIBUTES);
        }
      }
    }
  }

  private static String resource(String name) throws IOException {
    try (InputStream input = RankingBenchmark.class.getResourceAsStream("/ranking/" + name)) {
      return new String(input.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
