package dev.eventchain.messages;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * A package of ROS 2: a folder with a manifest (REP 149).
 *
 * @param name the name in its manifest, which need not be that of the folder
 */
public record RosPackage(String name, Path folder) {

  /** Name of the manifest. */
  public static final String MANIFEST = "package.xml";

  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9]*(_[a-z0-9]+)*");

  /**
   * Returns the package of a folder; empty without a manifest, or where that is unreadable, no XML,
   * or without a legal name.
   */
  public static Optional<RosPackage> of(Path folder) {
    Path manifest = folder.resolve(MANIFEST);
    if (!Files.isRegularFile(manifest)) {
      return Optional.empty();
    }
    try (InputStream input = Files.newInputStream(manifest)) {
      return name(input).map(name -> new RosPackage(name, folder));
    } catch (IOException | XMLStreamException e) {
      return Optional.empty();
    }
  }

  private static Optional<String> name(InputStream manifest) throws XMLStreamException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    XMLStreamReader reader = factory.createXMLStreamReader(manifest);
    int depth = 0;
    while (reader.hasNext()) {
      int event = reader.next();
      if (event == XMLStreamReader.END_ELEMENT) {
        depth--;
      } else if (event == XMLStreamReader.START_ELEMENT) {
        depth++;
        if (depth == 2 && reader.getLocalName().equals("name")) {
          return Optional.of(reader.getElementText().strip())
              .filter(name -> NAME.matcher(name).matches());
        }
      }
    }
    return Optional.empty();
  }
}
