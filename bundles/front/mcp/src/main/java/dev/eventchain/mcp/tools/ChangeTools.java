package dev.eventchain.mcp.tools;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.Edit;
import dev.eventchain.mcp.project.McpRules;
import dev.eventchain.mcp.project.MeasuredChange;
import dev.eventchain.mcp.project.ProjectFiles;
import dev.eventchain.mcp.project.Proposal;
import dev.eventchain.mcp.project.TrialCopy;
import dev.eventchain.mcp.tools.Parameter.ArgumentType;
import dev.eventchain.mcp.tools.Tool.Call;
import dev.eventchain.mcp.tools.Tool.Effect;
import dev.eventchain.mcp.tools.Tool.Result;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The tools that propose changes and make them. */
final class ChangeTools {

  private static final int MOST = 20;

  private static final Map<String, Object> FILES =
      Map.of("type", "array", "items", Map.of("type", "string"));

  private static final Map<String, Object> CHECKED =
      Map.of("type", "boolean", "description", "Whether the check could be done.");

  private final Commands commands;
  private final Boundary boundary;
  private final Map<String, Checked> proposals = new LinkedHashMap<>();

  /**
   * A proposal that can be made.
   *
   * @param checked whether its check could be done, whatever that found
   */
  private record Checked(Proposal proposal, boolean checked) {}

  ChangeTools(Commands commands, Boundary boundary) {
    this.commands = commands;
    this.boundary = boundary;
  }

  /** Returns the tools. */
  List<Tool> all() {
    return List.of(propose(), measure(), apply());
  }

  private Tool propose() {
    Map<String, Object> output = new LinkedHashMap<>(Commands.OUTPUT);
    output.put("proposal", Map.of("type", "string", "description", "Its name, for 'apply'."));
    output.put("checked", CHECKED);
    output.put("diff", Map.of("type", "string", "description", "The change as a unified diff."));
    output.put("judges", judges());
    return new Tool(
        "propose",
        "Check a change without making it",
        "Makes a change on a copy of the project, checks the copy, and returns the change as a diff"
            + " with what the check said. The project stays as it is. Results, settings,"
            + " suppressions, accepted findings and recordings cannot be changed.",
        Effect.READS,
        List.of(
            CommandTools.PROJECT,
            Parameter.required(
                "edits",
                ArgumentType.OBJECTS,
                "The changes, one after the other: {\"file\": relative to the project, \"old\": text"
                    + " that occurs once in it, \"new\": what takes its place}. Without \"old\","
                    + " \"new\" is the whole file."),
            Parameter.oneOf(
                "check",
                "What checks the copy: 'validate' (the default, seconds) or 'run' (to a verdict).",
                List.of("validate", "run"))),
        output,
        this::proposed);
  }

  private static Map<String, Object> judges() {
    Map<String, Object> schema = new LinkedHashMap<>(FILES);
    schema.put(
        "description",
        "Changed files that say what is right (requirements, scenarios, tests, constraints): with"
            + " them, a verdict means something else. A person should look at them.");
    return schema;
  }

  private Result proposed(Arguments arguments, Call call) {
    Path project = boundary.inside(arguments.text("project", "."));
    boundary.requireClosed(project);
    List<Edit> edits = arguments.list("edits").stream().map(ChangeTools::edit).toList();
    Proposal proposal = Proposal.of(boundary, project, edits);
    Result checked = checked(proposal, arguments.text("check", "validate"), call);
    Map<String, Object> structured = new LinkedHashMap<>(checked.structured());
    structured.putAll(described(proposal, checked));
    return new Result(textOf(proposal, checked) + checked.text(), structured, checked.failed());
  }

  /** Checks a proposal on a copy, and keeps it. */
  private Result checked(Proposal proposal, String command, Call call) {
    Result checked;
    try (TrialCopy copy = TrialCopy.of(boundary, proposal)) {
      List<String> arguments = List.of(command, boundary.argument(proposal.project()));
      checked = commands.report(arguments, copy.folder(), call);
    }
    keep(new Checked(proposal, !checked.failed()));
    return checked;
  }

  private static Map<String, Object> described(Proposal proposal, Result checked) {
    Map<String, Object> structured = new LinkedHashMap<>();
    structured.put("proposal", proposal.id());
    structured.put("checked", !checked.failed());
    structured.put("diff", proposal.diff());
    structured.put("judges", proposal.judges());
    return structured;
  }

  private static String textOf(Proposal proposal, Result checked) {
    String head = "Proposal " + proposal.id() + (checked.failed() ? ", unchecked" : "") + "\n";
    return head + proposal.diff() + "\n";
  }

  private Tool measure() {
    Map<String, Object> output = new LinkedHashMap<>(Commands.OUTPUT);
    output.put("proposal", Map.of("type", "string"));
    output.put("diff", Map.of("type", "string"));
    output.put("check", Map.of("type", "object", "description", "What 'validate' says of it."));
    return new Tool(
        "measure",
        "Measure a chain in a trace",
        "Compares a trace of ros2_tracing with the model. Worst cases that were exceeded are a"
            + " proposal, as of 'propose'; what one machine needed is no bound.",
        Effect.ADDS,
        List.of(
            CommandTools.PROJECT,
            Parameter.required(
                "trace",
                ArgumentType.TEXT,
                "The trace's folder, or the text of babeltrace2, in the server's folder.")),
        output,
        this::measured);
  }

  private Result measured(Arguments arguments, Call call) {
    Path project = boundary.inside(arguments.text("project", "."));
    boundary.requireClosed(project);
    String trace = boundary.closed(arguments.text("trace", ""));
    MeasuredChange change = MeasuredChange.before(project);
    Result measured = commands.report(List.of("measure", boundary.argument(project), trace), call);
    if (measured.failed()) {
      return measured;
    }
    try {
      return change.proposal(boundary).map(it -> proposed(measured, it, call)).orElse(measured);
    } catch (DiagnosticException e) {
      String refused = DiagnosticFormat.TEXT.render(e.diagnostics());
      return new Result(measured.text() + "\n" + refused, measured.structured(), false);
    }
  }

  /** Adds a proposal with its check to what was measured. */
  private Result proposed(Result measured, Proposal proposal, Call call) {
    Result checked = checked(proposal, "validate", call);
    Map<String, Object> structured = new LinkedHashMap<>(measured.structured());
    structured.putAll(described(proposal, checked));
    structured.put("check", checked.structured());
    String text = measured.text() + "\n" + textOf(proposal, checked) + checked.text();
    return new Result(text, structured, false);
  }

  private static Edit edit(Object json) {
    Map<?, ?> edit = (Map<?, ?>) json;
    Object old = edit.containsKey("old") ? edit.get("old") : "";
    boolean known = Set.of("file", "old", "new").containsAll(edit.keySet());
    if (known
        && edit.get("file") instanceof String file
        && old instanceof String replaced
        && edit.get("new") instanceof String text
        && text.length() <= ProjectFiles.LARGEST) {
      return new Edit(file, replaced, text);
    }
    throw Arguments.wrong(
        "An edit has \"file\" and \"new\", and may have \"old\"; all are texts.",
        "Such as {\"file\": \"model/chain.xmi\", \"old\": \"5\", \"new\": \"10\"}.");
  }

  private synchronized void keep(Checked checked) {
    String id = checked.proposal().id();
    proposals.remove(id);
    if (proposals.size() >= MOST) {
      proposals.remove(proposals.keySet().iterator().next());
    }
    proposals.put(id, checked);
  }

  private Tool apply() {
    return new Tool(
        "apply",
        "Make a proposed change",
        "Writes the files of a proposal as its diff says, if they are still as they were. Then use"
            + " 'run': no verdict is about the changed project yet.",
        Effect.CHANGES,
        List.of(
            Parameter.required(
                "proposal", ArgumentType.TEXT, "The name that 'propose' has given.")),
        Map.of("files", FILES, "checked", CHECKED),
        (arguments, call) -> applied(arguments.text("proposal", "")));
  }

  private synchronized Result applied(String id) {
    Checked kept = proposals.get(id);
    if (kept == null) {
      throw McpRules.refusal(
          McpRules.CHANGE,
          "",
          "There is no proposal '" + id + "' in this session.",
          "Propose the change; the last " + MOST + " proposals are kept.");
    }
    kept.proposal().apply(boundary);
    proposals.remove(id);
    List<String> files = List.copyOf(kept.proposal().changes().keySet());
    String unchecked =
        kept.checked() ? "" : "\nUnchecked: the check of this proposal failed to run.";
    return new Result(
        "Changed: " + String.join(", ", files) + unchecked,
        Map.of("files", files, "checked", kept.checked()),
        false);
  }
}
