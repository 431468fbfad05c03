package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.ResultTables;
import dev.eventchain.mcp.project.Table;
import dev.eventchain.mcp.tools.Parameter.ArgumentType;
import dev.eventchain.mcp.tools.Tool.Call;
import dev.eventchain.mcp.tools.Tool.Effect;
import dev.eventchain.mcp.tools.Tool.Result;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The tools that read results. */
final class ResultTools {

  private static final int PAGE = 50;
  private static final double AROUND_SECONDS = 0.5;
  private static final String CHANGED = "changedSince";

  private static final Map<String, Object> CHANGED_SCHEMA =
      Map.of(
          "type",
          "array",
          "items",
          Map.of("type", "string"),
          "description",
          "Files changed after these results were written: unless it is empty, the results are not"
              + " about the project as it is now.");

  private final Boundary boundary;

  ResultTools(Boundary boundary) {
    this.boundary = boundary;
  }

  /** Returns the tools. */
  List<Tool> all() {
    return List.of(results(), query(), signals());
  }

  private Tool results() {
    return new Tool(
        "results",
        "List tables of results",
        "Lists the tables that the results of a project hold: requirements, scenarios, criteria,"
            + " measurements, curves of scenarios, mutants, cases of campaigns.",
        Effect.READS,
        List.of(CommandTools.PROJECT),
        schema("tables", "array"),
        this::list);
  }

  private static Map<String, Object> schema(String name, String type) {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put(name, Map.of("type", type));
    schema.put(CHANGED, CHANGED_SCHEMA);
    return schema;
  }

  private Result list(Arguments arguments, Call call) {
    ResultTables tables = tables(arguments);
    List<Map<String, Object>> list = new ArrayList<>();
    StringBuilder text = new StringBuilder();
    for (String name : tables.names()) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("name", name);
      text.append(name);
      try {
        Table table = tables.table(name);
        entry.put("rows", table.rows().size());
        entry.put("columns", table.columns());
        text.append(": ").append(table.rows().size()).append(" rows\n");
      } catch (DiagnosticException e) {
        text.append(" cannot be read: ").append(e.getMessage()).append('\n');
      }
      list.add(entry);
    }
    return result(text, "tables", list, tables);
  }

  private Result result(StringBuilder text, String name, Object value, ResultTables tables) {
    Map<String, Object> structured = new LinkedHashMap<>();
    structured.put(name, value);
    structured.put(CHANGED, changed(text, tables));
    return new Result(text.toString(), structured, false);
  }

  private static List<String> changed(StringBuilder text, ResultTables tables) {
    List<String> changed = tables.changedSince();
    if (!changed.isEmpty()) {
      text.insert(0, "Changed after these results: " + String.join(", ", changed) + "\n");
    }
    return changed;
  }

  private Tool query() {
    Map<String, Object> output = schema("rows", "array");
    output.put("total", Map.of("type", "integer", "description", "Rows that match."));
    output.put(
        "next", Map.of("type", "integer", "description", "The offset of the next page, if any."));
    return new Tool(
        "query",
        "Read a table of results",
        "Reads rows of a table that 'results' lists, a page at a time.",
        Effect.READS,
        List.of(
            CommandTools.PROJECT,
            Parameter.required("table", ArgumentType.TEXT, "The table's name."),
            Parameter.of("columns", ArgumentType.TEXTS, "These columns only."),
            Parameter.of(
                "where",
                ArgumentType.OBJECTS,
                "Conditions that all hold: {\"column\": NAME} with \"equals\": VALUE, \"contains\":"
                    + " TEXT, \"least\": NUMBER or \"most\": NUMBER."),
            Parameter.of("orderBy", ArgumentType.TEXT, "Sort by this column, the smallest first."),
            Parameter.of("descending", ArgumentType.FLAG, "Sort with the largest first."),
            Parameter.of("offset", ArgumentType.WHOLE, "The first row, from 0."),
            Parameter.of(
                "limit",
                ArgumentType.WHOLE,
                "How many rows (default " + PAGE + ", at most " + Page.MOST + ").")),
        output,
        this::queried);
  }

  private Result queried(Arguments arguments, Call call) {
    ResultTables tables = tables(arguments);
    Table table = tables.table(arguments.text("table", ""));
    List<String> chosen = arguments.texts("columns");
    chosen.forEach(column -> require(column, table));
    List<Map<String, Object>> rows = matching(table, arguments);
    int from = Math.min(arguments.whole("offset").orElse(0), rows.size());
    Page page =
        Page.of(
            chosen.isEmpty() ? table.columns() : chosen,
            rows.subList(from, rows.size()),
            arguments.whole("limit").orElse(PAGE));
    int next = from + page.rows().size();
    String head = "Rows " + from + " to " + next + " of " + rows.size() + "\n";
    Result result = result(new StringBuilder(head + page.text()), "rows", page.rows(), tables);
    result.structured().put("total", rows.size());
    if (next < rows.size()) {
      result.structured().put("next", next);
    }
    return result;
  }

  /** Returns the rows that fulfil the conditions of a call, in its order. */
  private static List<Map<String, Object>> matching(Table table, Arguments arguments) {
    List<Map<String, Object>> rows = new ArrayList<>(table.rows());
    for (Object each : arguments.list("where")) {
      Condition condition = Condition.of((Map<?, ?>) each);
      require(condition.column(), table);
      rows.removeIf(row -> !condition.holds(row.get(condition.column())));
    }
    arguments
        .text("orderBy")
        .ifPresent(
            column -> {
              require(column, table);
              rows.sort(Condition.order(column, arguments.flag("descending")));
            });
    return rows;
  }

  private static void require(String column, Table table) {
    if (!table.columns().contains(column)) {
      throw Arguments.wrong(
          "The table has no column '" + column + "'.",
          NearestName.of(column, table.columns())
              .map(near -> "Did you mean '" + near + "'?")
              .orElse("It has: " + String.join(", ", table.columns()) + "."));
    }
  }

  private Tool signals() {
    Map<String, Object> output = schema("rows", "array");
    output.put(
        "leftOut", Map.of("type", "integer", "description", "Rows that were left out at the end."));
    return new Tool(
        "signals",
        "Read signals around a time",
        "Reads the signals of a scenario around a time, such as the time of a margin in the table"
            + " criteria: what the vehicle, the road and the topics did then.",
        Effect.READS,
        List.of(
            CommandTools.PROJECT,
            Parameter.required("scenario", ArgumentType.TEXT, "The scenario's name."),
            Parameter.required(
                "time", ArgumentType.NUMBER, "The time in s since the scenario's start."),
            Parameter.of("around", ArgumentType.NUMBER, "Seconds before and after (default 0.5)."),
            Parameter.of(
                "signals", ArgumentType.TEXTS, "Signals whose names contain one of these.")),
        output,
        this::around);
  }

  private Result around(Arguments arguments, Call call) {
    ResultTables tables = tables(arguments);
    Table curves = tables.curves(arguments.text("scenario", ""));
    List<String> columns = signals(curves, arguments.texts("signals"));
    double time = arguments.number("time").orElse(0.0);
    double around = arguments.number("around").orElse(AROUND_SECONDS);
    List<Map<String, Object>> rows =
        curves.rows().stream()
            .filter(
                row -> Condition.isWithin(row.get(columns.get(0)), time - around, time + around))
            .toList();
    Page page = Page.of(columns, rows, Page.MOST);
    Result result = result(new StringBuilder(page.text()), "rows", page.rows(), tables);
    result.structured().put("leftOut", rows.size() - page.rows().size());
    return result;
  }

  /** Returns the columns of the time and of the wanted signals. */
  private static List<String> signals(Table curves, List<String> wanted) {
    List<String> columns = new ArrayList<>();
    for (String name : curves.columns()) {
      if (columns.isEmpty() || wanted.isEmpty() || wanted.stream().anyMatch(name::contains)) {
        columns.add(name);
      }
    }
    if (columns.size() < 2) {
      throw Arguments.wrong(
          "The scenario has no such signal.",
          "It has: " + String.join(", ", curves.columns()) + ".");
    }
    return columns;
  }

  private ResultTables tables(Arguments arguments) {
    Path project = boundary.inside(arguments.text("project", "."));
    boundary.requireClosed(project);
    return new ResultTables(project);
  }
}
