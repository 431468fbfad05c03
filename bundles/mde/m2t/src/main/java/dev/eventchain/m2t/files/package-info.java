/**
 * Files of a run: names, charsets, and protected areas kept from earlier files. Knows no template.
 */
package dev.eventchain.m2t.files;
