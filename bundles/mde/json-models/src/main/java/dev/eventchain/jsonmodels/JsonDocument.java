package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import java.util.ArrayList;
import java.util.List;

/** Reads the JSON of instance models and of descriptions of chains and signals. */
public final class JsonDocument {

  private static final DocumentRules RULES =
      new DocumentRules(
          InstanceRules.JSON_SYNTAX,
          InstanceRules.JSON_SYNTAX,
          InstanceRules.VALUE_TYPE,
          InstanceRules.FEATURE_MISSING,
          InstanceRules.FEATURE_UNKNOWN,
          InstanceRules.VALUE_RANGE);

  private JsonDocument() {}

  /**
   * Reads a document: strict JSON, no property twice, nothing after its end, no control characters
   * in texts, at most 200 levels and 16 Mi characters.
   *
   * @throws DiagnosticException INPUT, {@code modeler.json.syntax} or {@code modeler.value.type},
   *     if it is not such a document
   */
  public static Document parse(SourceText source) {
    List<Diagnostic> findings = new ArrayList<>();
    Document document = Document.parse(source, DocumentFormat.JSON, RULES, findings::add);
    if (!findings.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, findings);
    }
    return document;
  }
}
