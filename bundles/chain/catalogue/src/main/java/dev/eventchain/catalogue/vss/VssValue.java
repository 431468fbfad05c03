package dev.eventchain.catalogue.vss;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.Document;

/** A value of a file, whose location is computed when it is asked for. */
record VssValue(JsonNode json, Document document, String pointer) {

  SourceLocation location() {
    return document.at(pointer);
  }

  SourceLocation key() {
    return document.atKey(pointer);
  }
}
