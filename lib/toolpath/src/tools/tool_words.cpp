// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lexicon of tool descriptions, and tables of numbered drills, screws and threads.
#include "tools/tool_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::toolpath::words {

namespace {

using text::Unit;

// A kind with its precedence: a "tapered ball end mill" is a tapered mill.
struct Named {
    std::optional<ToolKind> kind;
    int rank = 0;
};
constexpr Named kAny{};
constexpr Named kFlat{ToolKind::FlatEndMill, 1};
constexpr Named kDrill{ToolKind::Drill, 2};
constexpr Named kTap{ToolKind::Tap, 3};
constexpr Named kReamer{ToolKind::Reamer, 3};
constexpr Named kThreadMill{ToolKind::ThreadMill, 3};
constexpr Named kBoringBar{ToolKind::BoringBar, 1};
constexpr Named kFace{ToolKind::FaceMill, 4};
constexpr Named kBull{ToolKind::BullNoseEndMill, 5};
constexpr Named kBall{ToolKind::BallEndMill, 6};
constexpr Named kSlot{ToolKind::SlotMill, 7};
constexpr Named kDovetail{ToolKind::DovetailMill, 8};
constexpr Named kLollipop{ToolKind::LollipopMill, 9};
constexpr Named kCorner{ToolKind::CornerRoundingMill, 12};
constexpr Named kV{ToolKind::VCutter, 10};
constexpr Named kChamfer{ToolKind::ChamferMill, 10};
constexpr Named kCountersink{ToolKind::Countersink, 10};
constexpr Named kTaper{ToolKind::TaperedEndMill, 11};

struct Group {
    Role role;
    Named named;
    std::string_view entries;  // separated by bars; a star matches any letters
};

// Words of tool descriptions. Blanks in an entry match blanks, hyphens, points or underscores in a
// comment. The longest matching entry counts.
constexpr Group kGroups[] = {
    // English.
    {Role::Noun, kFlat,
     "END MILL|ENDMILL*|END MILLS|EM|E M|FLATENDMILL|FLAT END MILL|FLAT END|FLAT MILL|SQUARE END|"
     "SLOT MILL|SLOT CUTTER|SLOT DRILL|SLOTDRILL|ROUTER BIT|STRAIGHT BIT|"
     "CYLINDRICALCUTTER|ROUGHER|FLAT NOSE|END MIL|ENDMIL|FISHTAIL"},
    {Role::Noun, kBall,
     "BALL END|BALL END MILL|BALLENDMILL|BALL ENDMILL|BALL NOSE|BALLNOSE*|BALL NOSED|BALL MILL|"
     "BALLMILL|SPHERICALCUTTER|BALL CUTTER|BALL NOSE END MILL|BALL EM|BALLEND"},
    {Role::Noun, kBull,
     "BULL NOSE|BULLNOSE*|BULL NOSE END MILL|BULL END MILL|BULLENDMILL|BULL MILL|BULLMILL|"
     "RADIUS MILL|TIP RADIUSED|RADIUSED END MILL|TOROIDALCUTTER|BULL ENDMILL"},
    {Role::Noun, kFace,
     "FACE MILL|FACEMILL|SHELL MILL|SHELLMILL|FACE CUTTER|FLY CUTTER|FLYCUTTER|SHELL CUTTER"},
    {Role::Noun, kV,
     "V BIT|VBIT|VEE BIT|V CUTTER|V GROOVE|V GROVE|V CARVE BIT|V TOOL|V MILL|SPOT DRILL|SPOTDRILL|"
     "CENTER DRILL|CENTERDRILL|CENTRE DRILL|CENTREDRILL|C DRILL|ENGRAVING BIT|ENGRAVING TOOL|"
     "ENGRAVER|ENGRAVING CUTTER|SPOTTING DRILL|SPOTTER|VEE CUTTER|V END MILL"},
    {Role::Noun, kChamfer,
     "CHAMFER MILL|CHAMFERMILL|CHAMFER TOOL|CHAMFER CUTTER|CHAMFER BIT|DEBURRING TOOL"},
    {Role::Noun, kCountersink, "COUNTERSINK|COUNTER SINK|C SINK|CSINK"},
    {Role::Noun, kSlot,
     "SIDE MILL|SIDE CUTTER|SIDE AND FACE CUTTER|SIDE AND FACE MILL|DISC MILL|DISC CUTTER|DISK "
     "MILL|"
     "T SLOT*|TSLOT*|KEYSEAT*|WOODRUFF*|KEY CUTTER|SLITTING SAW|T CUTTER"},
    {Role::Noun, kDovetail, "DOVETAIL*"},
    {Role::Noun, kLollipop, "LOLLIPOP*|UNDERCUT BALL"},
    {Role::Noun, kCorner,
     "CORNER ROUND|CORNER ROUNDER|CORNER ROUNDING|CORNER ROUNDING MILL|CORNER ROUNDING END MILL|"
     "CORNER ROUNDING ENDMILL|CORNER ROUNDING CUTTER|CORNER ROUNDING TOOL|CORNER ROUND MILL|"
     "CORNER ROUND END MILL|CORNER ROUND ENDMILL|ROUNDOVER|ROUNDOVER BIT|ROUND OVER|"
     "ROUND OVER BIT|CONCAVE RADIUS MILL|CONCAVE CUTTER"},
    {Role::Noun, kTaper,
     "TAPER MILL|TAPERED MILL|TAPERMILL|TAPERED END MILL|TAPERED ENDMILL|TAPERED BALL NOSE|"
     "TAPERED BALL|TAPERED BALL END MILL|TAPER END MILL|TAPER BALL"},
    {Role::Noun, kDrill,
     "DRILL|DRILL BIT|TWIST DRILL|JOBBER DRILL|STUB DRILL|TAP DRILL|SCREW MACHINE DRILL|"
     "SPADE DRILL|INSERT DRILL|FORM DRILL|CARBIDE DRILL"},
    {Role::Noun, kTap,
     "TAP|FORM TAP|CUT TAP|SPIRAL TAP|ROLL TAP|RIGID TAP|RIGHT HAND TAP|LEFT HAND TAP"},
    {Role::Noun, kReamer, "REAMER|FORM REAMER"},
    {Role::Noun, kThreadMill, "THREAD MILL|THREADMILL"},
    {Role::Noun, kBoringBar, "BORING BAR|BORING HEAD"},
    {Role::Noun, kAny, "CUTTER|BIT|MILL|COMPRESSION BIT|ROUTER|CORN BIT|BURR|FORM MILL"},
    {Role::Shape, kFlat, "FLAT"},
    {Role::Attribute, kFlat, "SQUARE|UPCUT|UP CUT|DOWNCUT|DOWN CUT|CYLINDRICAL"},
    {Role::Shape, kBall, "BALL|SPHERICAL"},
    {Role::Shape, kBull, "BULL|RADIUSED|TOROIDAL"},
    {Role::Shape, kV, "CHAMFER|CHAMFERING|ENGRAVE|ENGRAVING|SPOT|VEE|V|CONICAL"},
    {Role::Shape, kTaper, "TAPERED"},
    {Role::Attribute, kAny,
     "CARBIDE|CARB|CRB|SOLID|HSS|HSSE|HSCO|COBALT|COATED|UNCOATED|TIN|TIALN|ALTIN|TICN|ZRN|DLC|PCD|"
     "INSERT|INDEXABLE|INSERTED|LONG|SHORT|STUB|EXTENDED|REGULAR|STANDARD|STD|XL|NECK|NECKED|"
     "REDUCED|SPIRAL|HELIX|HELICAL|SINGLE|DOUBLE|TWO|THREE|FOUR|FINISH|FINISHING|FINISHER|FIN|"
     "ROUGH|ROUGHING|ROUGHER|RUFF|RGH|HOG|CORNCOB|METAL|WOOD|ALUMINUM|ALUMINIUM|ALU|ALUM|ALUMIN|"
     "STEEL|PLASTIC|ACRYLIC|COMPRESSION|UP|DOWN|UPDOWN|CENTER CUTTING|CENTRE CUTTING|RIGHT|LEFT|"
     "HAND|RH|LH|CUTTING|TYPE|NOSE|END|METRIC|INCH|MM|IN|MAKERA|AMANA|WHITESIDE|HARVEY|SANDVIK|"
     "KENNAMETAL|OSG|MITSUBISHI|ISCAR|NIAGARA|YG|GUHRING|KYOCERA|HELICAL|LAKESHORE|SPEBIT|FREUD|"
     "ONSRUD|SECO|WALTER|HOFFMANN|GARANT|SPETOOL|JOBBER|NEW|OLD|USED|SET|MICRO|MINI|PCB|O|TOOTH|"
     "TEETH|CLEARANCE|PLUNGE|COARSE|FINE|GRAIN|HIGH|PERFORMANCE|HP|HEAVY|DUTY|CORNER|WITH|W|"
     "SLIDE|PRESS|FIT|CLOSE|FREE|FORM|CUT|MACHINE|MAIN|NC|CNC|POINT|PARABOLIC|COOLANT|THRU|SPECIAL|"
     "GROUND|CUSTOM|SIZE|VARIABLE|RATIO|BOTTOM|BOTTOMING|PLUG|MODIFIED|STRAIGHT|TAPER|TAPER SHANK"},
    {Role::Tool, kAny,
     "TOOL|T|TL|TC|TOOL NO|TOOL NUMBER|TOOL NUM|TOOL NR|TOOL CHANGE|TOOLCHANGE|CHANGE TOOL|"
     "TOOL CHANGE TO|CHANGE TOOL TO|CHANGE TOOL BIT TO|CHANGE BIT TO|COMPENSATED TOOL PATH|"
     "LOAD TOOL|INSERT TOOL|INSTALL TOOL|USE TOOL|USING TOOL|TOOL USED|TOOL NAME|TOOL DESCRIPTION|"
     "TOOL COMMENT|TOOL TYPE|CURRENT TOOL|TOOLS|LOAD|INSTALL"},
    {Role::Diameter, kAny,
     "D|DIA|DIAM|DIAMETER|TOOL DIA|TOOL DIAMETER|TOOL DIAM|CUTTER DIA|CUTTER DIAMETER|BIT DIAMETER|"
     "BIT DIA|CUTTING DIAMETER|TOOL SIZE|BIT SIZE|"
     "MILL SIZE|CUTTER SIZE|DC"},
    {Role::CornerRadius, kAny,
     "R|CR|RAD|RADIUS|CORNER RADIUS|CORNER RAD|C R|TIP RADIUS|NOSE RADIUS|RE|CNR RAD|C RAD"},
    {Role::ToolRadius, kAny, "TOOL RADIUS|CUTTER RADIUS|BIT RADIUS|ENDMILL RADIUS"},
    {Role::Tip, kAny, "TIP|TIP DIA|TIP DIAMETER|POINT DIA|TIP WIDTH|FLAT TIP"},
    {Role::Angle, kAny,
     "ANGLE|ANG|INCLUDED|INCL|DEG|DEGREE|DEGREES|POINT ANGLE|TIP ANGLE|INCLUDED ANGLE|TAPER ANGLE|"
     "CUTTING ANGLE"},
    {Role::FluteLength, kAny,
     "LOC|FLUTE LENGTH|LENGTH OF CUT|CUT LENGTH|CUTTING LENGTH|CUTTER LENGTH|FLUTE LEN|LCF|FLL"},
    {Role::Shank, kAny, "SHANK|SHANK DIA|SHANK DIAMETER|SHAFT|SHK|SHANK D"},
    {Role::StickOut, kAny,
     "STICKOUT|STICK OUT|OUT OF HOLDER|OOH|PROJECTION|EXTENSION|STICKING OUT"},
    {Role::Flutes, kAny,
     "FLUTE|FLUTES|FLUTED|FL|FLT|FLTS|FLS|F|Z|LIP|LIPS|NOF|INSERTS|FLUTE COUNT|NUMBER OF FLUTES"},
    {Role::Gauge, kAny, "NO|NUMBER|NUM|NR|LETTER|LTR|WIRE|GAUGE"},
    {Role::Other, kAny,
     "H|HO|DO|ID|S|L|OAL|LEN|LENGTH|OVERALL LENGTH|REACH|GAUGE LENGTH|DIA OFF|DIA OFFSET|LEN OFF|"
     "LENGTH OFFSET|DIAMETER OFFSET|OFFSET NO|RPM|SPEED|SPINDLE|FEED|FEEDRATE|SFM|IPM|ZMIN|Z MIN|"
     "COLLET|TPI|UNC|UNF|N|G|M|P|PITCH|STOCK TO LEAVE|TOOL LENGTH|TLO|POCKET NO|POS|OFFS|SEQ|OP|"
     "MIN Z|ITEM|DOC|EDP|PN|P N|PART NO|B|C|CC|SPINDLE SPEED|TL OFF|CUTTER COMP|WEAR"},
    {Role::Purpose, kAny, "FOR|OR|FUER|FUR|POUR|PARA|PER|VOOR|EQUIV|EQUIVALENT"},
    {Role::Prose, kAny,
     "THE|A|AN|AND|IS|SLOT|SLOTS|ARE|OF|TO|ON|AT|FROM|BY|AS|BE|IT|THIS|THAT|USE|USES|USED|USING|"
     "WILL|CAN|NOT|IF|"
     "WHEN|THEN|THAN|OUR|YOUR|MY|YOU|WE|HAS|HAVE|HAD|DOES|DO NOT|MAKE|MAKES|MADE|FITS|ONLY|BOTH|"
     "EACH|EVERY|ALL|FOUR OF|PREVIOUS|AFTER|BEFORE|BETWEEN|INTO|OVER|UNDER|ABOVE|BELOW|AROUND|"
     "ACROSS|DEEPER|STARTING|START|STOP|BEGIN|OPERATION|HOLE|HOLES|STOCK|PLATE|SHEET|THREAD|"
     "THREADS|"
     "BORE|BORES|BORING|POCKET|POCKETS|POCKETING|SLOTTING|HOLDER|DEPTH|DEEP|THICK|THICKNESS|WIDE|"
     "WIDTH|HEIGHT|TALL|OFFSET|OFFSETS|PASS|PASSES|STEPOVER|STEP|STEPDOWN|CONTOUR|PROFILE|"
     "PROFILING|"
     "FACING|DRILLING|DRILLED|TAPPING|MILLING|REAMING|CHAMFERS|MILLED|CLEAR|CUTS|CUTOUT|OUTLINE|"
     "MATERIAL|PLYWOOD|MDF|FOAM|OAK|PINE|BIRCH|BOARD|BLANK|SIZES|TOOLPATH|PATH|PROGRAM|FILE|PART|"
     "PARTS|SIDE|TOP|EDGE|EDGES|CIRCLE|CIRCLES|RECTANGLE|ARC|LINE|PATTERN|SPACING|CENTERS|DISTANCE|"
     "LEAVE|ALLOWANCE|TOLERANCE|DISABLE|ENABLE|CANCEL|COMPENSATION|COMP|PROBE|SETTER|SENSOR|REMOVE|"
     "RELEASE|MEASURE|CHANGE TO|SCREW|SCREWS|BOLT|BOLTS|NUT|BEARING|SHOULDER|RADII|FILLET|FIXTURE|"
     "VISE|CLAMP|PECK|RETRACT|RAPID|MOVE|MOVES|POSITION|DIAMETERS|TOOL HOLDER|TOOL BREAK|"
     "HEAD|WALL|WALLS|FLOOR|RIB|ISLAND|LETTERS|TEXT|LOGO|ADAPTIVE|TRACE|TABS|COPY|COPIES|KERF|"
     "SPEED AND FEED|FEEDS|NOZZLE|LASER|PLASMA|EXTRUDER|LAYER|FILAMENT|TURN|TURNING|PEN|KNIFE|"
     "NEED|NEEDS|MUST|SHOULD|ABOUT|APPROX|INSTEAD|WAS|WERE|SAME|THROUGH|UNTIL|RUN|RUNS|LIKE|JUST|"
     "PLEASE|HERE|THERE|WHICH|WHERE|WITHOUT|HOW|WHAT|MAX|MAXIMUM|MINIMUM|SMALL|LARGE|BIG|RETROFIT|"
     "LENS|VERSION|DATE|TIME|MIN|SEC|HOURS|SECONDS|MINUTES|CREATED|GENERATED|POST|OUTPUT|DWELL"},
    // German.
    {Role::Noun, kFlat,
     "SCHAFTFR*|LANGLOCHFR*|NUTENFR*|BOHRNUTENFR*|SCHRUPPFR*|SCHLICHTFR*|FINGERFR*|EINSCHNEIDER|"
     "ZWEISCHNEIDER|WALZENFR*"},
    {Role::Noun, kBall, "KUGELFR*|RADIUSFR*|KUGELKOPFFR*|VOLLRADIUSFR*|RADIENFR*"},
    {Role::Noun, kBull, "TORUSFR*|ECKRADIUSFR*|ECKENRADIUSFR*|TORUS"},
    {Role::Noun, kFace, "PLANFR*|MESSERKOPF*|PLANMESSERKOPF*|ECKMESSERKOPF"},
    {Role::Noun, kV,
     "GRAVIER*|GRAVUR*|STICHEL|"
     "V FRAESER|V FRASER|V NUTFR*|NC ANBOHRER|ANBOHRER|ZENTRIERBOHRER|ZENTRIERER|ZENTRIER*|"
     "KEGELFR*"},
    {Role::Noun, kChamfer, "FASENFR*|FASFR*|ENTGRATER|ENTGRATFR*"},
    {Role::Noun, kCountersink, "FASENSENKER|KEGELSENKER|SENKER"},
    {Role::Noun, kDrill,
     "BOHRER|SPIRALBOHRER|VHM BOHRER|WENDEPLATTENBOHRER|STUFENBOHRER|HSS BOHRER"},
    {Role::Noun, kCorner, "VIERTELKREISFR*|VIERTELRUNDFR*|ABRUNDFR*|ECKENRUNDFR*"},
    {Role::Noun, kTap, "GEWINDEBOHRER|GEWINDEFORMER"},
    {Role::Noun, kThreadMill, "GEWINDEFR*"},
    {Role::Noun, kReamer, "REIBAHLE|MASCHINENREIBAHLE"},
    {Role::Noun, kBoringBar, "BOHRSTANGE|AUSDREHKOPF|FEINBOHRKOPF"},
    {Role::Noun, kSlot, "T NUTENFR*|T NUTFR*|SCHEIBENFR*"},
    {Role::Noun, kDovetail, "SCHWALBENSCHWANZ*"},
    {Role::Noun, kAny, "FRAESER|FRASER|HM FRAESER|VHM FRAESER"},
    {Role::Attribute, kAny,
     "VHM|HM|LANG|KURZ|MIT|SCHRUPPEN|SCHLICHTEN|VOLLHARTMETALL|HARTMETALL|STAHL|HOLZ|BESCHICHTET|"
     "UND|FISCHSCHWANZ|SCHNEIDIG|ZAHNIG|EINZAHN|SPITZE"},
    {Role::Tool, kAny,
     "WERKZEUG|WZ|WERKZEUG NR|WERKZEUGNUMMER|WERKZEUGWECHSEL|WZG|OUTIL|OUTIL NO|UTENSILE|"
     "HERRAMIENTA|FERRAMENTA|CAMBIO UTENSILE|CHANGEMENT OUTIL|CAMBIO DE HERRAMIENTA|UT"},
    {Role::Diameter, kAny, "DURCHMESSER|DM|DIAMETRE|DIAMETRO|DURCHM|DIAMETR"},
    {Role::CornerRadius, kAny, "RAYON|RADIO|RAGGIO|ECKRADIUS|ECKENRADIUS|RAYON DE COIN"},
    {Role::Angle, kAny, "GRAD|WINKEL|SPITZENWINKEL|DEGRES|GRADOS|GRADI|ANGOLO|ANGULO|ANGLE DE"},
    {Role::FluteLength, kAny, "SCHNEIDENLAENGE|SCHNEIDLAENGE|LONGUEUR DE COUPE|SCHNEIDENLANGE"},
    {Role::Other, kAny, "LAENGE|LANGE|LONGUEUR|LARGO|LUNGHEZZA|DREHZAHL|VORSCHUB|LG"},
    {Role::Shank, kAny, "SCHAFT|QUEUE|MANGO|GAMBO"},
    {Role::Flutes, kAny,
     "SCHNEIDEN|SCHNEIDER|ZAEHNE|ZAHNE|ZAHN|DENTS|DENT|FILOS|FILO|LABIOS|LABIO|TAGLIENTI|TAGLIENTE|"
     "DENTI|LEVRES|DIENTES"},
    {Role::Prose, kAny,
     "BOHRUNG|BOHRUNGEN|TASCHE|NUT|KONTUR|PLANEN|MATERIALDICKE|DICKE|TIEFE|TIEF|ROHTEIL|GEWINDE|"
     "BREITE|DER|DIE|DAS|EIN|EINE|AUF|VON|BEI|FRAESEN|FRASEN|BOHREN|TROU|TROUS|POCHE|PROFONDEUR|"
     "EPAISSEUR|LES|UN|UNE|SUR|AVEC LE|BRUT|TARAUDAGE|PERCAGE|USINAGE|AGUJERO|AGUJEROS|TALADROS|"
     "CAJERA|CAJERAS|PROFUNDIDAD|ESPESOR|FORO|FORI|TASCA|TASCHE DI|PROFONDITA|SPESSORE|LAMIERA|"
     "GREZZO|MATERIALE|MATERIAU|CONTORNO|DEL|LOS|LAS|IL|CON EL|WERKSTUECK|PLATTE"},
    // French, Spanish, Italian, Portuguese; FREZA and related words.
    {Role::Noun, kFlat,
     "FRAISE CYLINDRIQUE|FRAISE DEUX TAILLES|FRAISE PLATE|FRAISE DROITE|FRAISE CARBURE|"
     "FRAISE EBAUCHE|FRAISE FINITION|FRESA PLANA|FRESA CON PUNTA PLANA|FRESA CILINDRICA|"
     "FRESA RECTA|FRESA PIANA|FRESA DE TOPO|FRESA DE DESBASTE|FRESA DE ACABADO|FRESA METAL DURO|"
     "FRESA TOPO|FRESA A CANDELA|FRESA SGROSSARE|FRESA FINITURA|FRESA MD"},
    {Role::Noun, kBall,
     "FRAISE HEMISPHERIQUE|FRAISE BOULE|FRAISE SPHERIQUE|FRAISE A BOUT ROND|FRAISE BOUT ROND|"
     "FRESA ESFERICA|FRESA DE BOLA|FRESA BOLA|FRESA PUNTA REDONDA|FRESA CON PUNTA ESFERICA|"
     "FRESA PUNTA ESFERICA|FRESA SFERICA|FRESA A SFERA|FRESA EMISFERICA"},
    {Role::Noun, kBull,
     "FRAISE TORIQUE|FRAISE RAYONNEE|FRESA TORICA|FRESA TOROIDAL|FRESA TOROIDALE|FRESA RAGGIATA"},
    {Role::Noun, kFace,
     "FRAISE A SURFACER|SURFACEUSE|FRAISE SURFACER|PLATO DE FRESAR|PLATO DE PLANEAR|"
     "FRESA DE PLANEAR|FRESA FRONTAL|FRESA DE PLANEADO|FRESA A SPIANARE|FRESA PER SPIANARE|"
     "FRESA SPIANATURA|CABEZAL DE FRESAR|PLATO PLANEAR"},
    {Role::Noun, kV,
     "FORET A CENTRER|FORET A POINTER|FORET CENTRER|FRAISE A GRAVER|FRAISE GRAVURE|FRAISE CONIQUE|"
     "POINTE A GRAVER|BROCA DE CENTRAR|BROCA DE PUNTEAR|BROCA CENTRAR|FRESA DE GRABADO|"
     "FRESA GRABADO|FRESA EN V|PUNTA DA CENTRO|PUNTA CENTRO|CENTRINO|BULINO|FRESA CONICA|"
     "PUNTA A CENTRARE|FRESA INCISIONE"},
    {Role::Noun, kChamfer,
     "FRAISE A CHANFREINER|FRAISE CHANFREIN|FRESA DE CHAFLAN|FRESA CHAFLAN|FRESA A SMUSSO|"
     "FRESA SMUSSO|FRESA PER SMUSSI"},
    {Role::Noun, kCountersink, "AVELLANADOR|SVASATORE"},
    {Role::Noun, kDrill, "FORET|FORETS|BROCA|BROCA HELICOIDAL|PUNTA|PUNTA ELICOIDALE|WIERTLO|BOOR"},
    {Role::Noun, kCorner,
     "FRAISE QUART DE ROND|FRAISE A ARRONDIR|FRESA DE REDONDEAR|FRESA PER RAGGIATURA"},
    {Role::Noun, kTap, "TARAUD|MACHO|MACHO DE ROSCAR|MASCHIO|MASCHIO A FILETTARE"},
    {Role::Noun, kReamer, "ALESOIR|ESCARIADOR|ALESATORE"},
    {Role::Noun, kDovetail, "FRAISE QUEUE D ARONDE|FRESA COLA DE MILANO|FRESA A CODA DI RONDINE"},
    {Role::Noun, kSlot, "FRAISE A RAINURER EN T|FRAISE EN T|FRESA EN T|FRESA A T"},
    {Role::Noun, kAny, "FRAISE|FRESA|FREZA|FREZ|FREES|MECHE"},
    {Role::Attribute, kAny,
     "CARBURE|LONGUE|COURTE|LARGA|CORTA|LUNGA|EBAUCHE|FINITION|DESBASTE|ACABADO|METAL DURO|MD|"
     "SGROSSATURA|FINITURA|DE|DA|DI|AVEC|CON|ACIER|ALUMINIO|"
     "ALLUMINIO|BOIS|MADERA|LEGNO"},
};

struct Entry {
    std::string_view text;
    Role role;
    Named named;
    std::size_t word_count;
    bool open_end;  // matches any letters at the end
};

// Entries by first letter, those with the most words first; made once.
using Lexicon = std::array<std::vector<Entry>, 26>;
const Lexicon& lexicon() {
    static const Lexicon entries = [] {
        Lexicon all;
        for (const Group& group : kGroups) {
            for (std::string_view entry : text::split(group.entries, '|')) {
                const bool open_end = entry.back() == '*';
                if (open_end) entry.remove_suffix(1);
                const auto blanks = std::count(entry.begin(), entry.end(), ' ');
                all[static_cast<std::size_t>(entry.front() - 'A')].push_back(
                    {entry, group.role, group.named, static_cast<std::size_t>(blanks) + 1,
                     open_end});
            }
        }
        for (auto& bucket : all) {
            std::stable_sort(bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) {
                if (a.word_count != b.word_count) return a.word_count > b.word_count;
                return !a.open_end && b.open_end;
            });
        }
        return all;
    }();
    return entries;
}

bool is_ascii_letter(char c) {
    return c >= 'A' && c <= 'Z';
}

// True for a mark that may join the words of an entry: END-MILL, END_MILL, DIA. OFF.
bool joins(const Token& token) {
    const bool mark = token.is('-') || token.is('_') || token.is('.') || token.is('\'');
    return mark && (token.joined_left || token.joined_right);
}

// Returns the end of the words of `entry` that begin at tokens[at]; 0 if the words do not match.
std::size_t end_of(const Entry& entry, const std::vector<Token>& tokens, std::size_t at) {
    std::string_view rest = entry.text;
    for (std::size_t i = 0; i < entry.word_count; ++i) {
        if (i > 0 && at < tokens.size() && joins(tokens[at])) ++at;
        if (i > 1 && at < tokens.size() && joins(tokens[at])) ++at;
        if (at >= tokens.size() || !tokens[at].is_word()) return 0;
        const std::size_t blank = rest.find(' ');
        const std::string_view word = rest.substr(0, blank);
        const std::string_view part = tokens[at++].text;
        const bool last = i + 1 == entry.word_count;
        if (last && entry.open_end ? part.substr(0, word.size()) != word : part != word) return 0;
        rest.remove_prefix(last ? rest.size() : blank + 1);
    }
    return at;
}

std::vector<Token> cut(std::string_view s) {
    std::vector<Token> tokens;
    bool blank_before = true;
    for (std::size_t at = 0; at < s.size();) {
        if (s[at] == ' ' || s[at] == '\t' || s[at] == '\r') {
            blank_before = true;
            ++at;
            continue;
        }
        Token token;
        token.joined_left = !blank_before;
        if (!tokens.empty()) tokens.back().joined_right = !blank_before;
        blank_before = false;
        std::size_t end = at + 1;
        const bool digit =
            is_digit(s[at]) || (s[at] == '.' && at + 1 < s.size() && is_digit(s[at + 1]));
        if (digit) {
            token.form = Token::Form::Number;
            // TOOL 1 1/2 is tool 1 and half an inch.
            const auto follows = [&tokens](std::string_view word) {
                return !tokens.empty() && tokens.back().text == word;
            };
            const bool counts = follows("TOOL") || follows("T") || follows("NO") || follows("#");
            std::size_t whole = s.find_first_not_of("0123456789", at);
            const bool two = whole < s.size() && whole + 1 < s.size() && s[whole] == ' ' &&
                             (is_digit(s[whole + 1]) || s[whole + 1] == '.');
            if (!counts || !two) whole = std::string_view::npos;
            const auto quantity = text::quantity_at(s.substr(0, whole), at);
            if (!quantity) break;  // too many digits for a number
            token.quantity = *quantity;
            end = token.quantity.end;
            // 6,35 has a decimal comma if it cannot be a list.
            const bool comma = end + 1 < s.size() && s[end] == ',' && is_digit(s[end + 1]) &&
                               token.quantity.unit == Unit::None && !token.quantity.is_fraction &&
                               s.substr(at, end - at).find('.') == std::string_view::npos;
            if (comma) {
                const std::size_t behind = s.find_first_not_of("0123456789", end + 1);
                if (behind == std::string_view::npos || (s[behind] != ',' && s[behind] != '.')) {
                    std::string dotted(s);
                    dotted[end] = '.';
                    token.quantity = text::quantity_at(dotted, at).value_or(token.quantity);
                    end = token.quantity.end;
                }
            }
            token.text = std::string(s.substr(at, end - at));
        } else if (is_ascii_letter(s[at])) {
            token.form = Token::Form::Word;
            while (end < s.size() && is_ascii_letter(s[end]))
                ++end;
            token.text = std::string(s.substr(at, end - at));
        } else {
            token.text = std::string(1, s[at]);
        }
        tokens.push_back(std::move(token));
        at = end;
    }
    return tokens;
}

}  // namespace

std::string plain_upper(std::string_view s) {
    // Replacements of Latin-1 characters from 0xC0 on; a blank replaces a mark without a letter.
    static constexpr std::array<std::string_view, 32> kLatin = {
        "A", "A", "A", "A", "AE", "A", "AE", "C", "E",    "E", "E", "E", "I",  "I", "I", "I",
        "D", "N", "O", "O", "O",  "O", "OE", "X", "DIA ", "U", "U", "U", "UE", "Y", "T", "SS"};
    std::string result;
    result.reserve(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
        auto byte = static_cast<unsigned char>(s[i]);
        if (byte < 0x80) {
            result += uppercase(s.substr(i, 1));
            continue;
        }
        if (s.substr(i, 3) == "\xE2\x8C\x80") {  // diameter sign
            result += "DIA ";
            i += 2;
            continue;
        }
        if (byte == 0xC2 && i + 1 < s.size()) byte = static_cast<unsigned char>(s[++i]);
        if (byte == 0xC3 && i + 1 < s.size() &&
            (static_cast<unsigned char>(s[i + 1]) & 0xC0) == 0x80)
            byte = static_cast<unsigned char>(static_cast<unsigned char>(s[++i]) | 0x40U);
        if (byte == 0xB0 || byte == 0xBA) {
            result += "\xB0";
        } else if (byte >= 0xC0 && byte != 0xFF) {
            result += kLatin[byte & 0x1FU];
        } else {
            result += ' ';
        }
    }
    return result;
}

std::vector<Token> tokens_of(std::string_view plain_upper_text) {
    std::vector<Token> parts = cut(plain_upper_text);
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < parts.size();) {
        Token token = std::move(parts[at]);
        std::size_t end = at + 1;
        if (token.is_word()) {
            parts[at].form = Token::Form::Word;
            parts[at].text = token.text;
            const auto& bucket = lexicon()[static_cast<std::size_t>(token.text.front() - 'A')];
            for (const Entry& entry : bucket) {
                const std::size_t behind = end_of(entry, parts, at);
                if (behind == 0) continue;
                end = behind;
                token.role = entry.role;
                token.kind = entry.named.kind;
                token.rank = entry.named.rank;
                for (std::size_t i = at + 1; i < end; ++i)
                    token.text.append(joins(parts[i]) ? "" : " " + parts[i].text);
                token.joined_right = parts[end - 1].joined_right;
                break;
            }
        }
        tokens.push_back(std::move(token));
        at = end;
    }
    return tokens;
}

std::optional<ToolKind> kind_named(std::string_view s) {
    std::optional<ToolKind> kind;
    int rank = 0;
    for (const Token& token : tokens_of(plain_upper(s.substr(0, kLongest)))) {
        if (token.rank > rank) kind = token.kind, rank = token.rank;
    }
    return kind;
}

double number_drill(int number) {
    // In 1/10000 inch, from number 1 on.
    static constexpr std::array<int, 80> kSizes = {
        2280, 2210, 2130, 2090, 2055, 2040, 2010, 1990, 1960, 1935, 1910, 1890, 1850, 1820,
        1800, 1770, 1730, 1695, 1660, 1610, 1590, 1570, 1540, 1520, 1495, 1470, 1440, 1405,
        1360, 1285, 1200, 1160, 1130, 1110, 1100, 1065, 1040, 1015, 995,  980,  960,  935,
        890,  860,  820,  810,  785,  760,  730,  700,  670,  635,  595,  550,  520,  465,
        430,  420,  410,  400,  390,  380,  370,  360,  350,  330,  320,  310,  292,  280,
        260,  250,  240,  225,  210,  200,  180,  160,  145,  135};
    if (number < 1 || number > 80) return 0.0;
    return kSizes[static_cast<std::size_t>(number - 1)] / 10000.0;
}

double letter_drill(char letter) {
    // In 1/1000 inch, from A on.
    static constexpr std::array<int, 26> kSizes = {234, 238, 242, 246, 250, 257, 261, 266, 272,
                                                   277, 281, 290, 295, 302, 316, 323, 332, 339,
                                                   348, 358, 368, 377, 386, 397, 404, 413};
    return is_ascii_letter(letter) ? kSizes[static_cast<std::size_t>(letter - 'A')] / 1000.0 : 0.0;
}

double centre_drill(int number) {
    // In 1/16 inch: body diameters of plain centre drills.
    static constexpr std::array<int, 8> kSizes = {2, 3, 4, 5, 7, 8, 10, 12};
    if (number < 1 || number > 8) return 0.0;
    return kSizes[static_cast<std::size_t>(number - 1)] / 16.0;
}

double coarse_pitch(double diameter) {
    struct Thread {
        double diameter, pitch;
    };
    static constexpr Thread kCoarse[] = {
        {1.0, 0.25}, {1.2, 0.25},  {1.6, 0.35}, {2.0, 0.4},  {2.5, 0.45}, {3.0, 0.5},
        {3.5, 0.6},  {4.0, 0.7},   {5.0, 0.8},  {6.0, 1.0},  {7.0, 1.0},  {8.0, 1.25},
        {10.0, 1.5}, {12.0, 1.75}, {14.0, 2.0}, {16.0, 2.0}, {18.0, 2.5}, {20.0, 2.5},
        {22.0, 2.5}, {24.0, 3.0},  {27.0, 3.0}, {30.0, 3.5}, {36.0, 4.0}};
    const auto* found = std::ranges::find(kCoarse, diameter, &Thread::diameter);
    return found == std::end(kCoarse) ? 0.0 : found->pitch;
}

double number_screw(int number) {
    return number < 0 || number > 14 ? 0.0 : 0.060 + 0.013 * number;
}

}  // namespace ncsim::toolpath::words
