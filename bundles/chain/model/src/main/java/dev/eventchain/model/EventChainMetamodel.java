package dev.eventchain.model;

import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiStore;
import java.io.ByteArrayInputStream;
import java.io.IOException;
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
 * Metamodel of event chains, its standard constraints, and the metamodel of message definitions:
 * the files of the folder {@code metamodel/}, as packaged with the program.
 */
public final class EventChainMetamodel {

  private static final String CONSTRAINTS = "metamodel/eventchain.ocl";

  private EventChainMetamodel() {}

  /**
   * Returns a store for the files below a folder, which may be event chains. See {@link XmiStore}.
   */
  public static XmiStore store(Path projectRoot) {
    return store(List.of(projectRoot));
  }

  /** Returns a store for the files below several folders, which may be event chains. */
  public static XmiStore store(Collection<Path> folders) {
    return store(folders, Map.of());
  }

  /**
   * Returns a store for the files below several folders, with replacements of reference prefixes.
   */
  public static XmiStore store(Collection<Path> folders, Map<String, Path> map) {
    return new XmiStore(folders, map, List.of(EventchainPackage.eINSTANCE));
  }

  /** Returns the text of the metamodel of event chains. */
  public static String text() {
    return resource("metamodel/eventchain.ecore");
  }

  /** Returns the standard constraints on event chains, in Complete OCL. */
  public static SourceText constraints() {
    return SourceText.of(CONSTRAINTS, resource(CONSTRAINTS));
  }

  /** Returns the metamodel of event chains as its file says it, with the documentation. */
  public static EPackage documented() {
    return read("metamodel/eventchain.ecore");
  }

  /** Returns the metamodel of message definitions, which templates may use. */
  public static EPackage messages() {
    return Messages.PACKAGE;
  }

  /** Lazy holder of the metamodel of message definitions, which most runs do not need. */
  private static final class Messages {
    private static final EPackage PACKAGE = read("metamodel/messages.ecore");
  }

  private static EPackage read(String name) {
    Resource resource = new EcoreResourceFactoryImpl().createResource(URI.createURI(name));
    byte[] text = resource(name).getBytes(StandardCharsets.UTF_8);
    try {
      resource.load(new ByteArrayInputStream(text), Map.of());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return (EPackage) resource.getContents().get(0);
  }

  private static String resource(String name) {
    return ResourceText.of(EventChainMetamodel.class, "/" + name);
  }
}
