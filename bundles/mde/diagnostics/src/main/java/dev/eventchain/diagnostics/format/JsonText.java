package dev.eventchain.diagnostics.format;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;

/** Writer of indented JSON; lines end with LF. */
final class JsonText {

  private final JsonGenerator json;

  /** Content of a document, object or array. */
  interface Content {
    void write(JsonText json) throws IOException;
  }

  private JsonText(JsonGenerator json) {
    this.json = json;
  }

  /** Returns a document whose root is an object. */
  static String document(Content members) {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
      DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
      json.setPrettyPrinter(
          new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter));
      new JsonText(json).object(members);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text + "\n";
  }

  /** Writes an object into an array. */
  void object(Content members) throws IOException {
    json.writeStartObject();
    members.write(this);
    json.writeEndObject();
  }

  void object(String name, Content members) throws IOException {
    json.writeFieldName(name);
    object(members);
  }

  void array(String name, Content elements) throws IOException {
    json.writeArrayFieldStart(name);
    elements.write(this);
    json.writeEndArray();
  }

  /** Writes a text into an array. */
  void text(String value) throws IOException {
    json.writeString(value);
  }

  void text(String name, String value) throws IOException {
    json.writeStringField(name, value);
  }

  void number(String name, long value) throws IOException {
    json.writeNumberField(name, value);
  }

  void truth(String name, boolean value) throws IOException {
    json.writeBooleanField(name, value);
  }

  void textIfKnown(String name, String value) throws IOException {
    if (!value.isEmpty()) {
      text(name, value);
    }
  }

  void numberIfKnown(String name, int value) throws IOException {
    if (value > 0) {
      number(name, value);
    }
  }
}
