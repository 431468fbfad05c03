package dev.eventchain.workspace.launch;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.LongNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * File of parameters: names of nodes, below which {@code ros__parameters} has values. Their types
 * are those that rcl's reader takes, in which {@code on} and {@code y} are Booleans.
 */
final class ParameterFile {

  private static final String PARAMETERS = "ros__parameters";
  private static final Set<String> TRUE =
      Set.of("Y", "y", "yes", "Yes", "YES", "True", "TRUE", "on", "On", "ON");
  private static final Set<String> FALSE =
      Set.of("N", "n", "no", "No", "NO", "False", "FALSE", "off", "Off", "OFF");

  /**
   * Texts without quotes that may be numbers of C: octal and hexadecimal ones, and no finite one.
   */
  private static final Pattern UNCLEAR =
      Pattern.compile("[-+]?(0[0-9xX.][0-9a-fA-FxXpP.+-]*|\\.?(?i:inf|infinity|nan))");

  private final SourceText source;
  private final Document document;
  private final Questions questions;
  private final List<ParameterAssignment> found = new ArrayList<>();

  private ParameterFile(SourceText source, Document document, Questions questions) {
    this.source = source;
    this.document = document;
    this.questions = questions;
  }

  /**
   * Returns what a file assigns, in its order.
   *
   * @param questions receives what is not known
   */
  static List<ParameterAssignment> read(SourceText source, Questions questions) {
    List<Diagnostic> problems = new ArrayList<>();
    try {
      DocumentRules rules = DocumentRules.all(LaunchRules.LAUNCH);
      Document document = Document.parse(source, DocumentFormat.YAML, rules, problems::add);
      if (problems.isEmpty()) {
        ParameterFile file = new ParameterFile(source, document, questions);
        file.nodes(document.root(), "", "");
        return file.found;
      }
    } catch (DiagnosticException e) {
      problems.addAll(e.diagnostics());
    }
    ask(questions, problems.get(0).message(), source.name(), problems.get(0).location());
    return List.of(ParameterAssignment.unknown());
  }

  private static void ask(Questions questions, String reason, String file, SourceLocation place) {
    questions.add(
        "Which parameters does this file give? It is not read: " + reason, file, place.line());
  }

  private void unread(String reason, String pointer) {
    ask(questions, reason, source.name(), document.atKey(pointer));
    found.add(ParameterAssignment.unknown());
  }

  private void nodes(JsonNode level, String pointer, String name) {
    if (!level.isObject()) {
      unread("There has to be '" + PARAMETERS + "' above values.", pointer);
      return;
    }
    for (Map.Entry<String, JsonNode> each : level.properties()) {
      String inner = Document.below(pointer, each.getKey());
      if (!each.getKey().equals(PARAMETERS)) {
        nodes(each.getValue(), inner, name.isEmpty() ? each.getKey() : name + "/" + each.getKey());
      } else if (name.isEmpty() || !each.getValue().isObject()) {
        unread("'" + PARAMETERS + "' is below the name of a node, and above names.", inner);
      } else {
        values(each.getValue(), inner, name, "");
      }
    }
  }

  private void values(JsonNode level, String pointer, String node, String above) {
    for (Map.Entry<String, JsonNode> each : level.properties()) {
      String inner = Document.below(pointer, each.getKey());
      String name = above + each.getKey();
      if (each.getValue().isObject()) {
        values(each.getValue(), inner, node, name + ".");
        continue;
      }
      Optional<JsonNode> value = value(each.getValue(), inner);
      if (value.isEmpty() && !name.equals(LaunchParameters.SIMULATED)) {
        String text =
            "What is the parameter '%s' of the node '%s'? %s"
                .formatted(name, node, LaunchParameters.SAY);
        questions.add(text, source.name(), document.atKey(inner).line());
      }
      found.add(new ParameterAssignment(node, name, value));
    }
  }

  /** Returns a value of the type that a node gets; empty if that is not clear. */
  private Optional<JsonNode> value(JsonNode written, String pointer) {
    if (written.isArray()) {
      return list(written, pointer);
    } else if (written.isTextual()) {
      return isQuoted(pointer) ? Optional.of(written) : plain(written);
    } else if (written.isBoolean()) {
      return Optional.of(written);
    } else if (written.isIntegralNumber()) {
      return written.canConvertToLong()
          ? Optional.of(LongNode.valueOf(written.longValue()))
          : Optional.empty();
    }
    return written.isNumber() && Double.isFinite(written.doubleValue())
        ? Optional.of(DoubleNode.valueOf(written.doubleValue()))
        : Optional.empty();
  }

  private boolean isQuoted(String pointer) {
    SourceLocation place = document.at(pointer);
    char first = source.text().charAt(source.offset(place.line(), place.column()));
    return first == '\'' || first == '"';
  }

  private static Optional<JsonNode> plain(JsonNode written) {
    String text = written.asText();
    if (TRUE.contains(text) || FALSE.contains(text)) {
      return Optional.of(BooleanNode.valueOf(TRUE.contains(text)));
    }
    return UNCLEAR.matcher(text).matches() ? Optional.empty() : Optional.of(written);
  }

  /** Returns a list of values of one type, which is what a parameter can be. */
  private Optional<JsonNode> list(JsonNode written, String pointer) {
    ArrayNode list = JsonNodeFactory.instance.arrayNode();
    for (int i = 0; i < written.size(); i++) {
      Optional<JsonNode> value =
          written.get(i).isValueNode()
              ? value(written.get(i), Document.below(pointer, i))
              : Optional.empty();
      if (value.isEmpty() || (i > 0 && value.get().getClass() != list.get(0).getClass())) {
        return Optional.empty();
      }
      list.add(value.get());
    }
    return list.isEmpty() ? Optional.empty() : Optional.of(list);
  }
}
