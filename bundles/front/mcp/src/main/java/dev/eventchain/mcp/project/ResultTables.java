package dev.eventchain.mcp.project;

import static java.util.Comparator.naturalOrder;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** The tables among the results of a project. */
public final class ResultTables {

  private static final String CURVES = "curves/";
  private static final long LARGEST = 64 << 20;
  private static final int CHANGED_NAMES = 10;

  private final Path project;
  private final Path output;
  private final Map<String, Supplier<Table>> tables = new TreeMap<>();
  private final Set<Path> read = new LinkedHashSet<>();

  /**
   * Finds the tables of a project, in a folder inside the boundary that nothing leads out of.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if it has no results
   */
  public ResultTables(Path project) {
    this.project = project;
    this.output = new ProjectFolder(project).defaultOutput();
    find("requirements", ProjectLayout.VERDICT, verdict -> list(verdict.path("requirements")));
    find("scenarios", ProjectLayout.VERDICT, verdict -> list(verdict.path("scenarios")));
    find("criteria", ProjectLayout.VERDICT, ResultTables::criteria);
    find("mutants", ProjectLayout.MUTANT_RESULTS, mutants -> list(mutants.path("mutants")));
    findCsv();
    if (tables.isEmpty()) {
      throw McpRules.refusal(
          McpRules.RESULTS,
          "",
          "The project has no results.",
          "The tools run, simulate, mutate and campaign make some.");
    }
  }

  /** Source of a table. */
  private interface Rows {
    List<JsonNode> of(JsonNode json);
  }

  private void find(String name, String file, Rows rows) {
    Path path = output.resolve(file);
    if (Files.isRegularFile(path)) {
      tables.put(
          name,
          () -> {
            List<JsonNode> objects = new ArrayList<>();
            rows.of(json(path)).forEach(each -> objects.add(withoutLists(each)));
            return Table.ofObjects(objects);
          });
    }
  }

  private void findCsv() {
    if (!Files.isDirectory(output)) {
      return;
    }
    try (Stream<Path> files = Files.walk(output)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        String name = output.relativize(file).toString();
        if (name.endsWith(".csv")) {
          tables.put(name.substring(0, name.length() - 4), () -> Table.ofCsv(text(file)));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static List<JsonNode> list(JsonNode array) {
    List<JsonNode> list = new ArrayList<>();
    array.forEach(list::add);
    return list;
  }

  private static List<JsonNode> criteria(JsonNode verdict) {
    List<JsonNode> criteria = new ArrayList<>();
    for (JsonNode scenario : verdict.path("scenarios")) {
      for (JsonNode criterion : scenario.path("criteria")) {
        ObjectNode row = new ObjectMapper().createObjectNode();
        row.set("scenario", scenario.path("name"));
        criterion.properties().forEach(each -> row.set(each.getKey(), each.getValue()));
        criteria.add(row);
      }
    }
    return criteria;
  }

  /** Returns an object without lists of objects, which are other tables or too much for a cell. */
  private static JsonNode withoutLists(JsonNode row) {
    ObjectNode copy = row.deepCopy();
    List<String> names = new ArrayList<>();
    copy.properties()
        .forEach(
            each -> {
              if (each.getValue().path(0).isObject() || each.getKey().equals("criteria")) {
                names.add(each.getKey());
              } else if (each.getValue() instanceof ObjectNode inner) {
                copy.set(each.getKey(), withoutLists(inner));
              }
            });
    return copy.remove(names);
  }

  private JsonNode json(Path file) {
    try {
      return new ObjectMapper().readTree(text(file));
    } catch (IOException e) {
      throw McpRules.refusal(
          McpRules.RESULTS, file.getFileName().toString(), "It is no JSON.", "Run again.");
    }
  }

  private String text(Path file) {
    try {
      if (Files.size(file) > LARGEST) {
        throw McpRules.refusal(
            McpRules.RESULTS,
            file.getFileName().toString(),
            "A table of " + Files.size(file) + " bytes is not read; the limit is " + LARGEST,
            "Read the file by other means.");
      }
      read.add(file);
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the names of the tables. */
  public List<String> names() {
    return List.copyOf(tables.keySet());
  }

  /**
   * Returns a table.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if there is none of this name
   */
  public Table table(String name) {
    Supplier<Table> table = tables.get(name);
    if (table == null) {
      throw unknown("table", name, names());
    }
    return table.get();
  }

  /** Returns the curves of a scenario. */
  public Table curves(String scenario) {
    List<String> known =
        names().stream()
            .filter(name -> name.startsWith(CURVES))
            .map(name -> name.substring(CURVES.length()))
            .toList();
    if (!known.contains(scenario)) {
      throw unknown("scenario", scenario, known);
    }
    return tables.get(CURVES + scenario).get();
  }

  private static RuntimeException unknown(String kind, String name, List<String> known) {
    return McpRules.refusal(
        McpRules.RESULTS,
        "",
        "There are no results of a " + kind + " '" + name + "'.",
        NearestName.of(name, known)
            .map(near -> "Did you mean '" + near + "'?")
            .orElse("There are: " + String.join(", ", known) + "."));
  }

  /**
   * Returns files of the project that were changed after a table that was read here was written,
   * the first ones: the results are not about them.
   */
  public List<String> changedSince() {
    SortedSet<String> changed = new TreeSet<>();
    Optional<FileTime> oldest = read.stream().map(ResultTables::modified).min(naturalOrder());
    oldest.ifPresent(time -> addChanged(time, changed));
    return changed.stream().limit(CHANGED_NAMES).toList();
  }

  private void addChanged(FileTime time, Set<String> changed) {
    SimpleFileVisitor<Path> visitor =
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean skipped = folder.equals(output) || isHidden(folder);
            return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            String name = project.relativize(file).toString();
            if (!name.startsWith(".") && modified(file).compareTo(time) > 0) {
              changed.add(name);
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException problem) {
            changed.add(project.relativize(file).toString()); // It may have been.
            return FileVisitResult.CONTINUE;
          }
        };
    try {
      Files.walkFileTree(project, visitor);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private boolean isHidden(Path folder) {
    return project.relativize(folder).toString().startsWith(".");
  }

  /**
   * Returns when a file was changed; of one that cannot be asked, the latest time that there is.
   */
  private static FileTime modified(Path file) {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return FileTime.from(Instant.MAX);
    }
  }
}
