package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiStore;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.xmi.impl.EcoreResourceFactoryImpl;

/**
 * The metamodel of event chains, the constraints that hold for all of them, and the metamodel of
 * message definitions: the files of the folder {@code metamodel/}, as the program carries them.
 */
public final class EventChainMetamodel {

  private static final String CONSTRAINTS = "metamodel/eventchain.ocl";

  private EventChainMetamodel() {}

  /** A store for the files below a folder, which may be event chains. See {@link XmiStore}. */
  public static XmiStore store(Path projectRoot) {
    return store(List.of(projectRoot));
  }

  /** A store for the files below several folders, which may be event chains. */
  public static XmiStore store(Collection<Path> folders) {
    return store(folders, Map.of());
  }

  /**
   * A store for the files below several folders, with the beginnings of references that stand for
   * others.
   */
  public static XmiStore store(Collection<Path> folders, Map<String, Path> map) {
    return new XmiStore(folders, map, List.of(EventchainPackage.eINSTANCE));
  }

  /** The text of the metamodel of event chains. */
  public static String text() {
    return resource("metamodel/eventchain.ecore");
  }

  /** The constraints that hold for all event chains, in Complete OCL. */
  public static SourceText constraints() {
    return SourceText.of(CONSTRAINTS, resource(CONSTRAINTS));
  }

  /** The metamodel of message definitions, which templates may be about. */
  public static EPackage messages() {
    return Messages.PACKAGE;
  }

  /** Read when it is first needed: most runs do without. */
  private static final class Messages {
    private static final EPackage PACKAGE = read();

    private static EPackage read() {
      Resource resource =
          new EcoreResourceFactoryImpl().createResource(URI.createURI("messages.ecore"));
      byte[] text = resource("metamodel/messages.ecore").getBytes(StandardCharsets.UTF_8);
      try {
        resource.load(new ByteArrayInputStream(text), Map.of());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return (EPackage) resource.getContents().get(0);
    }
  }

  private static String resource(String name) {
    try (InputStream stream = EventChainMetamodel.class.getResourceAsStream("/" + name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
