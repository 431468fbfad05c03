package dev.eventchain.pipeline.evidence.format;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Component;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * The file {@code needs.json} of sphinx-needs, with the types (req, impl, test), the fields and the
 * link that every project has: a documentation needs no settings to import it, apart from ids with
 * other characters than sphinx-needs expects.
 */
final class NeedsJson {

  /** The only version in the file. */
  private static final String VERSION = "1";

  private final Evidence evidence;
  private final ObjectNode needs = JsonNodeFactory.instance.objectNode();
  private final Set<String> ids = new HashSet<>();

  private NeedsJson(Evidence evidence) {
    this.evidence = evidence;
    evidence.requirements().forEach(each -> ids.add(each.id()));
  }

  static String render(Evidence evidence) {
    return new NeedsJson(evidence).render();
  }

  private String render() {
    evidence.requirements().forEach(this::requirement);
    evidence.components().forEach(this::component);
    evidence.tests().forEach(this::test);
    ObjectNode file = JsonNodeFactory.instance.objectNode();
    file.put("project", evidence.name()).put("current_version", VERSION);
    ObjectNode version = file.putObject("versions").putObject(VERSION);
    version.put("needs_amount", needs.size());
    version.set("needs", needs);
    return JsonLayout.compact(file) + "\n";
  }

  private void requirement(Requirement requirement) {
    String strength = requirement.strength().map(it -> "\n\n" + it.words()).orElse("");
    String reason =
        requirement.reason().map(it -> "\n\n" + escaped(requirement.words())).orElse("");
    need(requirement.id(), "req", requirement.id(), List.of())
        .put("status", requirement.verdict().words())
        .put("content", escaped(requirement.text()) + reason + strength);
  }

  private void component(Component component) {
    need(id("COMPONENT", component.name()), "impl", component.name(), component.satisfies())
        .put("content", escaped(component.place().toString()));
  }

  private void test(Test test) {
    boolean isScenario = test.component().isEmpty();
    String kind = isScenario ? "SCENARIO" : "TEST";
    ObjectNode need =
        need(id(kind, test.fullName()), "test", test.fullName(), evidence.supportedBy(test));
    String text = test.text().isEmpty() ? "" : escaped(test.text()) + "\n\n";
    need.put("status", test.result().words());
    need.put("content", text + escaped(test.place().toString()));
    need.putArray("tags").add(isScenario ? "scenario" : "component_test");
  }

  private ObjectNode need(String id, String type, String title, List<String> links) {
    ObjectNode need = needs.putObject(id).put("id", id).put("type", type).put("title", title);
    links.forEach(need.putArray("links")::add);
    return need;
  }

  /** Returns an id of capital letters, digits and underscores, as sphinx-needs expects it. */
  private String id(String kind, String name) {
    String plain = kind + "_" + name.toUpperCase(Locale.ROOT).replaceAll("[^A-Z0-9]+", "_");
    String id = plain;
    for (int number = 2; !ids.add(id); number++) {
      id = plain + "_" + number;
    }
    return id;
  }

  /** Returns a text without markup: content is reStructuredText, or Markdown if they say so. */
  private static String escaped(String text) {
    return text.replaceAll("([\\\\*`|_<>\\[\\]])", "\\\\$1")
        .replaceFirst("^([^\\\\\\p{Alnum}])", "\\\\$1");
  }
}
