package dev.eventchain.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
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

  /** Row of a table about a case. */
  private record Row(String values, boolean failed) {}

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
    List<Row> grid = rows(project, "campaign", resource("grid.yaml"));
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
        String search =
            String.format(
                Locale.ROOT, "seed: %d%nsearch: {runs: %d, method: %s}%n", seed, RUNS, method);
        print(method, seed, rows(project, "search", resource("grid.yaml") + search), all);
      }
    }
  }

  private static void print(String method, int seed, List<Row> rows, Set<String> all) {
    Set<String> found = failed(rows);
    int first =
        IntStream.range(0, rows.size()).filter(i -> rows.get(i).failed()).findFirst().orElse(-1);
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
  private static Set<String> failed(List<Row> rows) {
    return rows.stream().filter(Row::failed).map(Row::values).collect(Collectors.toSet());
  }

  /** Returns the rows of the table of a command's results. */
  private List<Row> rows(Path project, String command, String text)
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
    List<String> header = cells(lines.get(0));
    int from = header.indexOf("speed");
    int to = header.indexOf("repetition");
    return lines.subList(1, lines.size()).stream()
        .map(RankingBenchmark::cells)
        .map(it -> new Row(it.subList(from, to).toString(), it.get(to + 1).equals("failed")))
        .toList();
  }

  /** Returns the cells of a line, of which those up to the verdict have no commas. */
  private static List<String> cells(String line) {
    return List.of(line.split(",", -1));
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
