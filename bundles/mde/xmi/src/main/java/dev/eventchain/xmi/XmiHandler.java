package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import java.io.StringReader;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EFactory;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.impl.DynamicEObjectImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.util.ExtendedMetaData;
import org.eclipse.emf.ecore.xmi.IllegalValueException;
import org.eclipse.emf.ecore.xmi.PackageNotFoundException;
import org.eclipse.emf.ecore.xmi.UnresolvedReferenceException;
import org.eclipse.emf.ecore.xmi.XMIException;
import org.eclipse.emf.ecore.xmi.XMLHelper;
import org.eclipse.emf.ecore.xmi.XMLResource;
import org.eclipse.emf.ecore.xmi.impl.SAXXMIHandler;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/**
 * EMF's reader of XMI, extended to record where each element starts, to report all problems instead
 * of the first, and to follow no schema, entity or Java class that a file names.
 */
final class XmiHandler extends SAXXMIHandler {

  private static final int DEEPEST_NESTING = 500;
  private static final int REMEMBERED_TEXTS = 1 << 12;

  private final XmiResource file;
  private final Map<EDataType, Boolean> harmless = new HashMap<>();
  private final String[] texts = new String[REMEMBERED_TEXTS];

  /** The namespaces of all versions of XMI. */
  private static final Pattern XMI =
      Pattern.compile("http://(www|schema)\\.omg\\.org/(spec/)?XMI(/.*)?");

  private int depth;

  /** Nesting depth inside an extension; 0 outside. */
  private int extension;

  private boolean ended;

  /** Factories of the classes that are named without a namespace. */
  private final Map<String, Optional<EFactory>> unqualified = new HashMap<>();

  /** True while looking up a class that is named without a namespace. */
  private boolean withoutNamespace;

  /** A reference that is being read from a text of ids. */
  private record IdsOf(EObject element, EReference feature, int tag) {}

  /** The reference whose ids are being split, already recorded as a whole; or null. */
  private IdsOf idsOf;

  /** The line and column at which {@link #tag} is the latest start tag. */
  private int tagLine;

  private int tagColumn;
  private int tag;

  XmiHandler(XmiResource file, XMLHelper helper, Map<?, ?> options) {
    super(file, helper, options);
    this.file = file;
  }

  @Override
  public void startElement(String uri, String localName, String qName, Attributes attributes)
      throws SAXException {
    if (extension > 0 || isExtension(qName)) {
      extension++;
      return;
    }
    depth++;
    if (depth > DEEPEST_NESTING) {
      throw new SAXParseException(
          "Elements are nested deeper than " + DEEPEST_NESTING + " levels.", locator);
    }
    super.startElement(uri, localName, qName, attributes);
  }

  @Override
  public void endElement(String uri, String localName, String name) {
    if (extension > 0) {
      extension--;
      return;
    }
    depth--;
    EObject open = objects.peekEObject();
    super.endElement(uri, localName, name);
    file.statements().close(open);
  }

  /**
   * Returns whether an element is an {@code xmi:Extension} or {@code xmi:Documentation}, with data
   * of tools outside the model.
   */
  private boolean isExtension(String name) {
    int colon = name.indexOf(':');
    if (colon < 0 || !(name.endsWith(":Extension") || name.endsWith(":Documentation"))) {
      return false;
    }
    String prefix = name.substring(0, colon);
    String uri = helper.getURI(prefix);
    return prefix.equals("xmi") || (uri != null && XMI.matcher(uri).matches());
  }

  @Override
  public void characters(char[] text, int start, int length) {
    if (extension == 0) {
      super.characters(text, start, length);
    }
  }

  @Override
  protected void processObject(EObject object) {
    super.processObject(object);
    if (object != null) {
      file.noteOrigin(object, tagOffset());
    }
  }

  @Override
  protected void handleProxy(InternalEObject proxy, String reference) {
    int place = file.problems().valueIn(tagOffset(), reference);
    String mapped = file.files().mapped(file.getURI(), reference);
    Optional<String> refusal = file.files().refusal(file.getURI(), mapped);
    if (refusal.isPresent()) {
      file.problems().add(XmiRules.HREF_REFUSED, refusal.get(), place, MappedUris.hint(reference));
      return;
    }
    super.handleProxy(proxy, mapped);
    file.noteProxy(proxy, place, objects.peekEObject());
    if (idsOf != null && Statements.hasWrittenOpposite(idsOf.feature())) {
      file.statements().ends().add(idsOf.element(), idsOf.feature(), proxy, idsOf.tag());
    }
  }

  /** Returns the offset of the tag that is being read; asked for each of its attributes. */
  private int tagOffset() {
    int line = getLineNumber();
    int column = getColumnNumber();
    if (line != tagLine || column != tagColumn) {
      tag = file.problems().tagEndingAt(line, column);
      tagLine = line;
      tagColumn = column;
    }
    return tag;
  }

  /**
   * Returns registered packages and profiles only; EMF would load files and Java classes that a URI
   * names.
   */
  @Override
  protected EPackage getPackageForURI(String uri) {
    EPackage known = packageRegistry.getEPackage(uri == null ? Namespaces.NONE : uri);
    if (known == null && uri != null) {
      known = file.profiles().definition(uri).orElse(null);
    }
    if (known == null && uri != null) {
      error(new PackageNotFoundException(uri, getLocation(), getLineNumber(), getColumnNumber()));
    }
    return known;
  }

  private Optional<EFactory> factoryOf(String typeName) {
    List<EClass> meant = Namespaces.withoutNamespace(typeName, packageRegistry);
    return meant.size() == 1
        ? Optional.of(meant.get(0).getEPackage().getEFactoryInstance())
        : Optional.empty();
  }

  @Override
  protected EObject createObjectFromFeatureType(EObject owner, EStructuralFeature feature) {
    withoutNamespace = false;
    boolean refers = attribs != null && attribs.getValue(XMLResource.HREF) != null;
    if (refers && feature.getEType() instanceof EClass type && type.isAbstract()) {
      // Its target decides the class of what an href without a type stands for.
      Optional<EObject> placeholder = Uml.instanceOf(type);
      if (placeholder.isPresent()) {
        handleObjectAttribs(placeholder.get());
        setFeatureValue(owner, feature, placeholder.get(), -1);
        processObject(placeholder.get());
        return placeholder.get();
      }
    }
    return super.createObjectFromFeatureType(owner, feature);
  }

  /** Returns a feature by the name that UML gives it as an XML element. */
  @Override
  protected EStructuralFeature getFeature(
      EObject object, String prefix, String name, boolean isElement) {
    String meant = isElement ? Uml.featureOfElement(object.eClass(), name) : name;
    return super.getFeature(object, prefix, meant, isElement);
  }

  @Override
  protected EFactory getFactoryForPrefix(String prefix) {
    withoutNamespace = prefix.isEmpty() && helper.getURI(prefix) == null;
    return super.getFactoryForPrefix(prefix);
  }

  @Override
  @SuppressWarnings("deprecation") // EMF uses this method for XMI.
  protected EObject createObjectFromFactory(EFactory factory, String typeName) {
    EFactory owner = factory;
    if (withoutNamespace && factory != null) {
      owner = unqualified.computeIfAbsent(typeName, this::factoryOf).orElse(null);
    }
    boolean isClass =
        owner != null && owner.getEPackage().getEClassifier(typeName) instanceof EClass;
    return isClass ? super.createObjectFromFactory(owner, typeName) : null;
  }

  /** Refuses values that EMF would deserialise or load as classes, as for some Ecore features. */
  @Override
  protected void setFeatureValue(
      EObject object, EStructuralFeature feature, Object value, int position) {
    if (feature.getEType() instanceof EDataType type
        && !harmless.computeIfAbsent(type, HarmlessTypes::contains)) {
      file.problems().refuseType(feature, tagOffset());
    } else if (isComputed(object, feature)) {
      file.problems().refuseComputed(feature, tagOffset());
    } else if (value instanceof String text && NonFiniteNumbers.contains(feature, text)) {
      file.problems().refuseNumber(feature, text, tagOffset());
    } else {
      note(object, feature, value);
      super.setFeatureValue(object, feature, shared(value), position);
      if (feature instanceof EAttribute attribute && attribute.isID()) {
        noteId(EcoreUtil.getID(object), object); // also for an id as an XML element
      }
    }
  }

  /** Returns whether only generated code could store a value; without it, EMF drops the value. */
  private static boolean isComputed(EObject object, EStructuralFeature feature) {
    return feature.isVolatile()
        && object instanceof DynamicEObjectImpl
        && ExtendedMetaData.INSTANCE.getGroup(feature) == null
        && ExtendedMetaData.INSTANCE.getMixedFeature(object.eClass()) == null;
  }

  private void note(EObject object, EStructuralFeature feature, Object value) {
    if (ended || idsOf != null) {
      return;
    }
    if (value instanceof EObject target
        && feature instanceof EReference reference
        && Statements.hasWrittenOpposite(reference)) {
      file.statements().ends().add(object, reference, target, tagOffset());
    }
    if (file.statements().fill(object, feature)) {
      file.problems().addSecondValue(feature, tagOffset());
    }
  }

  @Override
  protected void setValueFromId(EObject object, EReference reference, String text) {
    String kept = Statements.isId(text) ? file.sharedId(text) : text;
    List<String> ids = Statements.idsIn(kept);
    if (Statements.hasWrittenOpposite(reference)) {
      file.statements().noteEnds(object, reference, shared(ids), tagOffset());
    }
    if (file.statements().fill(object, reference) || (!reference.isMany() && ids.size() > 1)) {
      file.problems().addSecondValue(reference, tagOffset());
    }
    idsOf = new IdsOf(object, reference, tagOffset());
    super.setValueFromId(object, reference, kept);
    idsOf = null;
  }

  private List<String> shared(List<String> ids) {
    return ids.size() == 1
        ? ids
        : ids.stream().map(id -> Statements.isId(id) ? file.sharedId(id) : id).toList();
  }

  /** Returns a shared instance of equal texts, since models repeat types, units and topics. */
  private Object shared(Object value) {
    if (!(value instanceof String text)) {
      return value;
    }
    int slot = text.hashCode() & (REMEMBERED_TEXTS - 1);
    if (!text.equals(texts[slot])) {
      texts[slot] = text;
    }
    return texts[slot];
  }

  /** Records ids, which must be unique in a file. */
  @Override
  protected void handleObjectAttribs(EObject object) {
    super.handleObjectAttribs(object);
    noteId(file.getID(object), object);
    noteId(EcoreUtil.getID(object), object);
  }

  private void noteId(String id, EObject object) {
    if (id != null) {
      file.noteId(id, object, tagOffset());
    }
  }

  @Override
  protected void handleXSISchemaLocation(String schemaLocations) {
    file.profiles().note(schemaLocations);
  }

  @Override
  protected void handleXSINoNamespaceSchemaLocation(String schemaLocation) {
    // Metamodels come from the caller, never from a place that a model names.
  }

  @Override
  public InputSource resolveEntity(String publicId, String systemId) {
    return new InputSource(new StringReader(""));
  }

  /** Resolves references inside the file, when the parser is past their place. */
  @Override
  public void endDocument() {
    ended = true;
    super.endDocument();
  }

  @Override
  public void error(XMIException problem) {
    int tag = file.problems().tagEndingAt(problem.getLine(), problem.getColumn());
    if (ended && problem instanceof IllegalValueException value) {
      if (isSingleEnd(value)) {
        return; // EMF fails to reposition a value that is not in the list; Faults reports it.
      }
      tag = file.offsetOf(value.getObject(), tag);
    } else if (problem instanceof UnresolvedReferenceException reference) {
      tag = file.offsetOf(reference.getObject(), tag);
    }
    file.problems().add(problem, tag);
  }

  private static boolean isSingleEnd(IllegalValueException problem) {
    return problem.getFeature() instanceof EReference reference
        && Statements.hasWrittenOpposite(reference)
        && reference.getEType().isInstance(problem.getValue());
  }

  @Override
  public void fatalError(SAXParseException e) throws SAXException {
    throw e;
  }
}
