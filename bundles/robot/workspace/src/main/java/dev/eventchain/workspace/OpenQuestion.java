package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;

/**
 * Fact that the sources do not state, and somebody who knows the software has to.
 *
 * @param text a question
 * @param file the file that it is about, relative to the workspace
 * @param line counts from 1; 0 for the whole file
 */
public record OpenQuestion(String text, String file, int line) {

  static OpenQuestion of(JsonNode json) {
    return new OpenQuestion(
        json.path("text").asText(), json.path("file").asText(), json.path("line").asInt());
  }
}
