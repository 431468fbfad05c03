package dev.eventchain.xmi;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlText;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.Map;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.xmi.XMLHelper;
import org.eclipse.emf.ecore.xmi.XMLLoad;
import org.eclipse.emf.ecore.xmi.impl.XMILoadImpl;
import org.eclipse.emf.ecore.xmi.impl.XMIResourceImpl;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/** One XMI file of a project, read by {@link XmiHandler}. */
final class XmiResource extends XMIResourceImpl {

  private static final String NO_DOCTYPE = "http://apache.org/xml/features/disallow-doctype-decl";

  private final ProjectFiles files;
  private final EPackage.Registry registry;
  private final Origins origins;
  private final IdentityHashMap<EObject, Integer> proxies = new IdentityHashMap<>();
  private final IdentityHashMap<EObject, Integer> owners = new IdentityHashMap<>();
  private final Ids ids = new Ids();
  private final Statements statements = new Statements();
  private final AppliedProfiles profiles = new AppliedProfiles(this);
  private XmiProblems problems;
  private Offsets offsets;

  XmiResource(URI uri, ProjectFiles files, EPackage.Registry registry, Origins origins) {
    super(uri);
    this.files = files;
    this.registry = registry;
    this.origins = origins;
    this.problems = new XmiProblems(SourceText.of("", ""), registry, profiles::hint);
    this.offsets = new Offsets(problems.text());
  }

  /** Records the id of an element, which must be unique. */
  void noteId(String id, EObject element, int tag) {
    EObject first = ids.putIfAbsent(id, element);
    if (first != null && first != element) {
      statements.addFault(problems.duplicate(id, tag, offsetOf(first, tag)));
    }
  }

  /** Returns the instance to keep of a text with one id, since several references repeat it. */
  String sharedId(String id) {
    return ids.shared(id);
  }

  /** Records an id as EMF does, but not in its maps, which are several times as large. */
  @Override
  public void setID(EObject element, String id) {
    offsets.identify(element, id == null ? null : ids.shared(id));
  }

  @Override
  public String getID(EObject element) {
    return offsets.idOf(element);
  }

  /** Returns that EMF's maps of ids are not to be filled. */
  @Override
  protected boolean useIDs() {
    return false;
  }

  /**
   * Returns the element that an end of a reference means.
   *
   * @param target an element, a proxy or an id in this file
   * @return null if there is none
   */
  EObject targetOf(Object target) {
    if (target instanceof String id) {
      return getEObject(id);
    }
    InternalEObject element = (InternalEObject) target;
    return element.eIsProxy() ? getResourceSet().getEObject(element.eProxyURI(), false) : element;
  }

  /** Resolves a fragment as EMF does, but without its pool of weak references to every path. */
  @Override
  public EObject getEObject(String fragment) {
    if (!fragment.startsWith("/")) {
      return super.getEObject(fragment);
    }
    int end = endOfSegment(fragment, 1);
    EObject found = getEObjectForURIFragmentRootSegment(fragment.substring(1, end));
    while (found != null && end < fragment.length()) {
      int start = end + 1;
      end = endOfSegment(fragment, start);
      found =
          ((InternalEObject) found).eObjectForURIFragmentSegment(fragment.substring(start, end));
    }
    return found;
  }

  private static int endOfSegment(String fragment, int start) {
    int slash = fragment.indexOf('/', start);
    return slash < 0 ? fragment.length() : slash;
  }

  /** Looks up recorded ids only; EMF would search the whole file for each unknown id. */
  @Override
  protected EObject getEObjectByID(String id) {
    return ids.get(id);
  }

  ProjectFiles files() {
    return files;
  }

  AppliedProfiles profiles() {
    return profiles;
  }

  XmiProblems problems() {
    return problems;
  }

  /** Returns the location of the file as a whole. */
  SourceLocation place() {
    return SourceLocation.of(files.nameOf(Path.of(getURI().toFileString())));
  }

  Statements statements() {
    return statements;
  }

  void noteOrigin(EObject object, int offset) {
    offsets.put(object, offset);
  }

  /** Returns the offset of an element's start tag, or the given one if it is not known yet. */
  int offsetOf(EObject element, int otherwise) {
    int offset = element == null ? -1 : offsets.get(element);
    return offset < 0 ? otherwise : offset;
  }

  void noteProxy(EObject proxy, int offset, EObject owner) {
    proxies.put(proxy, offset);
    if (owner != null) {
      owners.put(owner, offset);
    }
  }

  /** Reports containment cycles; EMF follows references to the file itself while it reads. */
  private void refuseCircles() {
    owners.forEach(
        (owner, offset) -> {
          if (new Containers(owner).isCircle()) {
            problems.addCircle(offset);
          }
        });
  }

  /** Returns the offset of a reference to another file; 0 if it is not from this file. */
  int offsetOfProxy(EObject proxy) {
    return proxies.getOrDefault(proxy, 0);
  }

  /** Returns the message of an exception, or a default where Java only names its class. */
  private static String reason(RuntimeException e) {
    String message = e.getMessage();
    return message == null || message.contains("java.")
        ? "the reader cannot handle its structure."
        : message;
  }

  /** Reads the file. Findings are in {@link #problems()}; nothing is thrown. */
  @Override
  public void load(Map<?, ?> options) {
    if (!isLoaded()) {
      DiagnosticException.runAt(place(), this::read);
    }
  }

  private void read() {
    Path path = Path.of(getURI().toFileString());
    try {
      problems = new XmiProblems(XmlText.read(path, place().file()), registry, profiles::hint);
      offsets = origins.of(problems.text());
      load(new InputSource(new StringReader(problems.text().text())), Map.of());
      refuseCircles();
      if (getContents().isEmpty() && problems.found().isEmpty()) {
        problems.add(XmiRules.EMPTY, "The file contains no model element.", 0, "");
      }
    } catch (DiagnosticException e) {
      problems.found().addAll(e.diagnostics());
    } catch (IOException e) {
      problems.add(e);
    } catch (RuntimeException e) {
      // EMF's reader trusts its input; its failures are faults of the file.
      problems.add(XmiRules.SYNTAX, "The file is not valid XMI: " + reason(e), 0, "");
    }
  }

  @Override
  protected XMLLoad createXMLLoad() {
    return new Load(createXMLHelper());
  }

  private final class Load extends XMILoadImpl {

    private Load(XMLHelper helper) {
      super(helper);
    }

    @Override
    protected DefaultHandler makeDefaultHandler() {
      return new XmiHandler(XmiResource.this, helper, options);
    }

    @Override
    protected SAXParser makeParser() throws ParserConfigurationException, SAXException {
      SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
      factory.setFeature(NO_DOCTYPE, true);
      return factory.newSAXParser();
    }
  }
}
