package dev.eventchain.pipeline.report;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.pipeline.project.Templates;
import dev.eventchain.pipeline.run.RunResult.Verdict;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The report of a run as one self-contained HTML file with style, script and data. Its
 * Content-Security-Policy allows only exactly this style and this script.
 *
 * <p>The templates of templates/report generate the page from the model; all other inputs are text,
 * which they escape. The data of the script is untrusted, too: it is embedded as JSON that cannot
 * end the element or start another, and the script turns it into text nodes only. Without scripts,
 * a viewer shows the verdict, the chain, the requirements and the measured values.
 */
public final class ReportPage {

  /** Parts of the script in order; later parts use earlier ones. */
  private static final List<String> SCRIPTS =
      List.of(
          "dom.js",
          "scene.js",
          "timeline.js",
          "plots.js",
          "chain.js",
          "scenarios.js",
          "faults.js",
          "retrieved.js",
          "conversations.js",
          "head.js",
          "requirements.js",
          "measurements.js",
          "bounds.js",
          "shown.js",
          "report.js");

  /** The name of the report among the results of a run. */
  public static final String FILE = "report.html";

  /** The heading of the page. */
  public record Heading(String name, String title, Verdict verdict, String summary) {}

  private ReportPage() {}

  /**
   * Returns the page in UTF-8. The same model and data, in the same order, give the same bytes.
   *
   * @param chain the measured model; an empty one where there is none
   * @param data an object with the run's results, for the script; every part may be absent
   */
  public static byte[] render(EventChain chain, Heading heading, JsonNode data) {
    String style = "\n" + resource("report.css");
    String script =
        SCRIPTS.stream()
            .map(ReportPage::resource)
            .collect(Collectors.joining("\n", "\n\"use strict\";\n", ""));
    Map<String, String> properties =
        Map.of(
            "name",
            heading.name(),
            "title",
            heading.title(),
            "verdict",
            heading.verdict().name().toLowerCase(Locale.ROOT),
            "summary",
            heading.summary(),
            "policy",
            policy(style, script),
            "style",
            style,
            "script",
            script,
            "data",
            json(data));
    TemplateModule module =
        Templates.shipped("report", "report", List.of(EventchainPackage.eINSTANCE));
    GenerationResult result =
        module.generate(
            List.of(chain),
            GenerationContext.of(element -> SourceLocation.NONE).withProperties(properties));
    if (Diagnostic.anyError(result.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, result.diagnostics());
    }
    return result.files().get(FILE);
  }

  private static String policy(String style, String script) {
    return "default-src 'none'; style-src '%s'; script-src '%s'; base-uri 'none'; form-action 'none'"
        .formatted(hash(style), hash(script));
  }

  private static String hash(String text) {
    return "sha256-" + Base64.getEncoder().encodeToString(Sha256.of(text).bytes());
  }

  /** Returns JSON in ASCII without characters that are special in HTML. */
  private static String json(JsonNode data) {
    JsonMapper mapper = JsonMapper.builder().build();
    StringWriter text = new StringWriter();
    try (JsonGenerator generator = mapper.createGenerator(text)) {
      generator.setCharacterEscapes(new HtmlSafe());
      generator.enable(JsonWriteFeature.ESCAPE_NON_ASCII.mappedFeature());
      mapper.writeTree(generator, data);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  /** Returns a part of the page from its own file. */
  public static String resource(String name) {
    return ResourceText.of(ReportPage.class, name);
  }

  private static final class HtmlSafe extends CharacterEscapes {

    private static final long serialVersionUID = 1L;

    private final int[] escapes = standardAsciiEscapesForJSON();

    HtmlSafe() {
      for (char special : new char[] {'<', '>', '&'}) {
        escapes[special] = ESCAPE_STANDARD;
      }
    }

    @Override
    public int[] getEscapeCodesForAscii() {
      return escapes;
    }

    /** Returns no custom escapes: everything outside ASCII is already escaped. */
    @Override
    public SerializableString getEscapeSequence(int character) {
      return null;
    }
  }
}
