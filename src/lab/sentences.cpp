#include "lab/sentences.h"

#include <array>

#include "core/error.h"

namespace shadowlab::lab {
namespace {

constexpr std::array<std::string_view, 4> codes{"en", "ca", "es", "fr"};

using InAll = std::array<std::string_view, 4>;  // English, Catalan, Spanish, French

constexpr std::array sentences = std::to_array<InAll>({
    {"Right.", "Correcte.", "Correcto.", "Juste."},
    {"The picture differs from the expected one in {0} pixels; {1} may.",
     "La imatge difereix de l'esperada en {0} píxels; se n'admeten {1}.",
     "La imagen difiere de la esperada en {0} píxeles; se admiten {1}.",
     "L'image diffère de celle attendue en {0} pixels ; {1} sont admis."},
    {"After the pass \"{2}\" the stencil differs from the expected one in {0} pixels; {1} may.",
     "Després del pas «{2}» l'stencil difereix de l'esperat en {0} píxels; se n'admeten {1}.",
     "Tras el paso «{2}» el stencil difiere del esperado en {0} píxeles; se admiten {1}.",
     "Après la passe « {2} », le stencil diffère de celui attendu en {0} pixels ; {1} sont admis."},
    {"After the pass \"{2}\" the depth differs from the expected one in {0} pixels; {1} may.",
     "Després del pas «{2}» la profunditat difereix de l'esperada en {0} píxels; se n'admeten {1}.",
     "Tras el paso «{2}» la profundidad difiere de la esperada en {0} píxeles; se admiten {1}.",
     "Après la passe « {2} », la profondeur diffère de celle attendue en {0} pixels ; {1} sont "
     "admis."},
    {"The first pass that departs is \"{0}\": there the {1} differs in {2} pixels, mostly {3}, "
     "{4}.",
     "El primer pas que se'n separa és «{0}»: el que hi difereix és {1}, en {2} píxels, "
     "sobretot {3}, {4}.",
     "El primer paso que se aparta es «{0}»: lo que difiere allí es {1}, en {2} píxeles, sobre "
     "todo "
     "{3}, {4}.",
     "La première passe qui s'écarte est « {0} » : ce qui y diffère est {1}, en {2} pixels, "
     "surtout "
     "{3}, {4}."},
    {"Each pass is as expected; what is drawn after them departs in {0} pixels, mostly {1}, {2}.",
     "Cada pas és com s'espera; el que es dibuixa després difereix en {0} píxels, sobretot {1}, "
     "{2}.",
     "Cada paso es como se espera; lo que se dibuja después difiere en {0} píxeles, sobre todo "
     "{1}, "
     "{2}.",
     "Chaque passe est comme attendu ; ce qui est dessiné ensuite diffère en {0} pixels, surtout "
     "{1}, {2}."},
    {"There is no pass \"{0}\", which the reference has.",
     "No hi ha cap pas «{0}», que la referència sí que té.",
     "No hay ningún paso «{0}», que la referencia sí tiene.",
     "Il n'y a pas de passe « {0} », que la référence possède."},
    {"The pass \"{0}\" draws with {1} {2} where the reference has {3}.",
     "El pas «{0}» dibuixa amb {1} {2} on la referència té {3}.",
     "El paso «{0}» dibuja con {1} {2} donde la referencia tiene {3}.",
     "La passe « {0} » dessine avec {1} {2} là où la référence a {3}."},
    {"With that alone replaced, the picture is right.",
     "Si només es canvia això, la imatge és correcta.",
     "Cambiando solo eso, la imagen es correcta.", "En remplaçant cela seul, l'image est juste."},
    {"That alone does not mend the picture: something else differs too.",
     "Només amb això la imatge no s'arregla: hi ha alguna altra diferència.",
     "Solo con eso la imagen no se arregla: hay alguna otra diferencia.",
     "Cela seul ne répare pas l'image : autre chose diffère aussi."},
    {"The recipe fails: {0}", "La recepta falla: {0}", "La receta falla: {0}",
     "La recette échoue : {0}"},
    {"It was not drawn, since the recipe was ended before.",
     "No s'ha dibuixat, perquè la recepta s'ha aturat abans.",
     "No se ha dibujado, porque la receta se detuvo antes.",
     "Elle n'a pas été dessinée, car la recette a été arrêtée avant."},
    {"This case is hidden. Try your recipe with other lights, cameras and scenes.",
     "Aquest cas és ocult. Prova la recepta amb altres llums, càmeres i escenes.",
     "Este caso está oculto. Prueba la receta con otras luces, cámaras y escenas.",
     "Ce cas est caché. Essaie ta recette avec d'autres lumières, caméras et scènes."},
    {"Draw it: {0}", "Dibuixa-ho: {0}", "Dibújalo: {0}", "Dessine-le : {0}"},
    // buffers
    {"colour", "el color", "el color", "la couleur"},
    {"stencil", "l'stencil", "el stencil", "le stencil"},
    {"depth", "la profunditat", "la profundidad", "la profondeur"},
    // regions
    {"in the shadow", "a l'ombra", "en la sombra", "dans l'ombre"},
    {"where the light reaches", "on arriba la llum", "donde llega la luz",
     "là où la lumière arrive"},
    {"along edges", "al llarg de les vores", "a lo largo de los bordes", "le long des bords"},
    {"where nothing is behind", "on no hi ha res al darrere", "donde no hay nada detrás",
     "là où il n'y a rien derrière"},
    // places
    {"at the top left", "a dalt a l'esquerra", "arriba a la izquierda", "en haut à gauche"},
    {"at the top", "a dalt", "arriba", "en haut"},
    {"at the top right", "a dalt a la dreta", "arriba a la derecha", "en haut à droite"},
    {"at the left", "a l'esquerra", "a la izquierda", "à gauche"},
    {"in the middle", "al mig", "en el centro", "au milieu"},
    {"at the right", "a la dreta", "a la derecha", "à droite"},
    {"at the bottom left", "a baix a l'esquerra", "abajo a la izquierda", "en bas à gauche"},
    {"at the bottom", "a baix", "abajo", "en bas"},
    {"at the bottom right", "a baix a la dreta", "abajo a la derecha", "en bas à droite"},
    {"all over the picture", "per tota la imatge", "por toda la imagen", "dans toute l'image"},
    // states
    {"the depth test", "el depth test", "el depth test", "le test de profondeur"},
    {"the stencil test", "l'stencil test", "el stencil test", "le test du stencil"},
    {"blending", "el blending", "el blending", "le mélange (blending)"},
    {"face culling", "l'eliminació de cares", "la eliminación de caras", "l'élimination des faces"},
    {"the switch of polygon offset", "l'interruptor de polygon offset",
     "el interruptor de polygon offset", "l'interrupteur de polygon offset"},
    {"depth function", "la funció de profunditat", "la función de profundidad",
     "la fonction de profondeur"},
    {"depth mask", "la màscara de profunditat", "la máscara de profundidad",
     "le masque de profondeur"},
    {"colour mask", "la màscara de color", "la máscara de color", "le masque de couleur"},
    {"stencil function", "la funció d'stencil", "la función de stencil", "la fonction du stencil"},
    {"stencil operation", "l'operació d'stencil", "la operación de stencil",
     "l'opération du stencil"},
    {"stencil mask", "la màscara d'stencil", "la máscara de stencil", "le masque du stencil"},
    {"culled face", "la cara eliminada", "la cara eliminada", "la face éliminée"},
    {"front face", "la cara frontal", "la cara frontal", "la face avant"},
    {"blend function", "la funció de blending", "la función de blending", "la fonction de mélange"},
    {"blend equation", "l'equació de blending", "la ecuación de blending", "l'équation de mélange"},
    {"polygon offset", "el polygon offset", "el polygon offset", "le polygon offset"},
    {"viewport", "el viewport", "el viewport", "le viewport"},
    {"scissor box", "el rectangle de scissor", "el rectángulo de scissor",
     "le rectangle de scissor"},
    {"the uniform", "el uniform", "el uniform", "l'uniform"},
    {"the call {0}", "la crida {0}", "la llamada {0}", "l'appel {0}"},
    {"never set", "sense fixar", "sin fijar", "jamais fixé"},
    {"on", "activat", "activado", "activé"},
    {"off", "desactivat", "desactivado", "désactivé"},
    // the report
    {"Score", "Nota", "Nota", "Note"},
    {"Expected", "Esperada", "Esperada", "Attendue"},
    {"Yours", "Teva", "Tuya", "La tienne"},
    {"Difference", "Diferència", "Diferencia", "Différence"},
    {"Pass by pass", "Pas a pas", "Paso a paso", "Passe par passe"},
    {"Submissions", "Lliuraments", "Entregas", "Travaux rendus"},
    {"Cases", "Casos", "Casos", "Cas"},
    {"points", "punts", "puntos", "points"},
    {"hidden", "ocult", "oculto", "caché"},
    {"failed", "fallat", "fallado", "échoué"},
    {"error", "error", "error", "erreur"},
    {"It printed", "Ha escrit", "Escribió", "Elle a écrit"},
    {"Cases by failures", "Casos per errades", "Casos por fallos", "Cas par échecs"},
    {"Mistakes by frequency", "Errors per freqüència", "Errores por frecuencia",
     "Erreurs par fréquence"},
    {"The same GL calls", "Les mateixes crides de GL", "Las mismas llamadas de GL",
     "Les mêmes appels GL"},
    {"None.", "Cap.", "Ninguno.", "Aucun."},
});
static_assert(sentences.size() == static_cast<std::size_t>(Say::count));

}  // namespace

Language language_named(std::string_view code) {
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i] == code) return static_cast<Language>(i);
  }
  throw InputError(fmt::format("--lang takes en, ca, es or fr; \"{}\" given", code));
}

std::string_view code_of(Language language) { return codes[static_cast<std::size_t>(language)]; }

std::string_view text(Language language, Say what) {
  return sentences[static_cast<std::size_t>(what)][static_cast<std::size_t>(language)];
}

}  // namespace shadowlab::lab
